/// Commands that ask or tell a run with a page, and how runs get a page.
@NullMarked
package rsal.cli.page;

import org.jspecify.annotations.NullMarked;
