/// Where the known ends and who should go there.
@NullMarked
package rsal.navigation.explore;

import org.jspecify.annotations.NullMarked;
