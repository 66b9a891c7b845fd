/// What can be set of algorithms that are used outside of devices, too.
@NullMarked
package rsal.navigation.parameter;

import org.jspecify.annotations.NullMarked;
