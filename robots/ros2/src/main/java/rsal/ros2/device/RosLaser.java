package rsal.ros2.device;

import java.util.Optional;
import rsal.data.LaserScan;
import rsal.device.DeviceInfo;
import rsal.device.LaserScanner;
import rsal.robot.RobotModel.Part;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.ScanMessage;

/// A laser scanner that publishes `sensor_msgs/LaserScan`. Where it is on the robot is what TF says; before that
/// comes, what the robot's model says.
final class RosLaser extends RosSensor<LaserScan> implements LaserScanner {
    private final Part.Laser part;
    private final Frames frames;
    private final RobotClock clock;

    RosLaser(DeviceInfo info, String topic, Part.Laser part, Frames frames, RobotClock clock) {
        super(info, info.id(), topic);
        this.part = part;
        this.frames = frames;
        this.clock = clock;
    }

    void take(ScanMessage message) {
        if (message.isPossible()) {
            Optional<FrameTransform> baseFromLaser =
                    mount(frames, message.frame(), message.stamp(), FrameTransform.of(part.baseFromLaser()));
            baseFromLaser.ifPresent(mount -> {
                LaserScan scan = message.scan(mount, Double.POSITIVE_INFINITY);
                heard(frames.now());
                publish(clock.time(message.stamp()), scan);
            });
        }
    }
}
