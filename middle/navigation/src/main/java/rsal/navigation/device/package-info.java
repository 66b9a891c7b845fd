/// Makes devices of the algorithms: a localizer, a planner, a navigator. Only this package knows of devices and
/// time.
@NullMarked
package rsal.navigation.device;

import org.jspecify.annotations.NullMarked;
