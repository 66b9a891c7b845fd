/// Receivers of satellite navigation (GNSS, as GPS): how robots measure where they are outdoors.
@NullMarked
package rsal.device.gnss;

import org.jspecify.annotations.NullMarked;
