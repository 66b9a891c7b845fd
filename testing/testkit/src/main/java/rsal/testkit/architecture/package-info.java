/// What the compiler does not forbid and we do.
@NullMarked
package rsal.testkit.architecture;

import org.jspecify.annotations.NullMarked;
