/// Places spread evenly over a map, by the ways between them: where robots should stand to be near to everything.
@NullMarked
package rsal.navigation.spread;

import org.jspecify.annotations.NullMarked;
