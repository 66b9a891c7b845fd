/// Inertial measurement units: how robots measure their turning and their acceleration.
@NullMarked
package rsal.device.imu;

import org.jspecify.annotations.NullMarked;
