package rsal.ros2.device;

import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.device.imu.Imu;
import rsal.device.imu.ImuReading;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTransform.Quaternion;
import rsal.ros2.message.RosMessages;

/// An IMU that publishes `sensor_msgs/Imu`. What it measures in its own frame is turned to where the model has it, as
/// far as TF tells how it is mounted, also tilted or upside down. One without an orientation gets one by its
/// angular velocity.
final class RosImu extends RosSensor<ImuReading> implements Imu {
    private static final double LONGEST = 1e9; // ns, between readings of which the orientation is integrated

    private final FrameTransform baseFromDevice;
    private final Frames frames;
    private final RobotClock clock;
    private double turned; // integrated [rad]
    private long before; // stamp of the last message [ns]

    RosImu(DeviceInfo info, String topic, Pose2d baseFromDevice, Frames frames, RobotClock clock) {
        super(info, info.id(), topic);
        this.baseFromDevice = FrameTransform.of(baseFromDevice);
        this.frames = frames;
        this.clock = clock;
    }

    void take(RosMessage message) {
        RosMessage header = message.message("header");
        mount(frames, header.text("frame_id"), RosMessages.stamp(header), baseFromDevice)
                .ifPresent(baseFromImu ->
                        take(message, baseFromDevice.rotation().conjugate().times(baseFromImu.rotation())));
    }

    private void take(RosMessage message, Quaternion deviceFromImu) {
        double[] velocity = rotated(deviceFromImu, message.message("angular_velocity"));
        double[] acceleration = rotated(deviceFromImu, message.message("linear_acceleration"));
        long stamp = RosMessages.stamp(message.message("header"));
        double orientation = hasOrientation(message)
                ? heading(quaternion(message.message("orientation")).times(deviceFromImu.conjugate()))
                : integrated(stamp, velocity[2]);
        if (Double.isFinite(orientation + velocity[2] + acceleration[0] + acceleration[1])) {
            heard(frames.now());
            publish(clock.time(stamp), new ImuReading(orientation, velocity[2], acceleration[0], acceleration[1]));
        }
    }

    private static double[] rotated(Quaternion rotation, RosMessage vector) {
        return rotation.rotated(vector.number("x"), vector.number("y"), vector.number("z"));
    }

    private static Quaternion quaternion(RosMessage message) {
        return new Quaternion(message.number("x"), message.number("y"), message.number("z"), message.number("w"));
    }

    /// An orientation that is not measured has a covariance of -1; drivers that fill in nothing have a length of 0.
    private static boolean hasOrientation(RosMessage message) {
        Quaternion orientation = quaternion(message.message("orientation"));
        double length = Math.abs(orientation.x())
                + Math.abs(orientation.y())
                + Math.abs(orientation.z())
                + Math.abs(orientation.w());
        return message.get("orientation_covariance", double[].class)[0] != -1 && length > 0;
    }

    private static double heading(Quaternion mapFromDevice) {
        double[] ahead = mapFromDevice.unit().rotated(1, 0, 0);
        return Math.atan2(ahead[1], ahead[0]);
    }

    private double integrated(long stamp, double velocity) {
        double passed = stamp - before; // ns
        if (before != 0 && passed > 0 && passed < LONGEST && Double.isFinite(velocity)) {
            turned = Angles.wrap(turned + velocity * passed / 1e9);
        }
        before = stamp;
        return turned;
    }
}
