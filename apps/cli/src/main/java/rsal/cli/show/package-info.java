/// Commands that show and check files, and what is installed.
@NullMarked
package rsal.cli.show;

import org.jspecify.annotations.NullMarked;
