package rsal.ros2.device;

import java.time.Instant;
import java.util.function.Consumer;
import rsal.device.DeviceCore;
import rsal.ros2.link.RosLink.Subscribed;

/// A device of a robot, and what keeps it up.
///
/// @param look looks how it is, every [RosRobot#LOOK]
/// @param close takes its topics away, for good
record RosDevice(DeviceCore device, Consumer<Instant> look, Runnable close) {
    /// One whose readings come by one topic.
    static RosDevice of(RosSensor<?> sensor, Subscribed subscription) {
        return new RosDevice(sensor, now -> sensor.look(now, subscription.publishers()), subscription::close);
    }
}
