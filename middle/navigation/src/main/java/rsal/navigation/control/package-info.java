/// Controllers as people choose them and set their parameters. What they do is in packages of their own, which
/// know plain values only.
@NullMarked
package rsal.navigation.control;

import org.jspecify.annotations.NullMarked;
