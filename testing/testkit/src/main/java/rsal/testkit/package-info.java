/// What tests draw and measure with: maps as one sees them, and ranges by the slow, obvious way.
@NullMarked
package rsal.testkit;

import org.jspecify.annotations.NullMarked;
