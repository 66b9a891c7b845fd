package rsal.ros2.bridge;

import java.util.List;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.Gripper;
import rsal.device.Navigator;
import rsal.device.camera.Camera;
import rsal.device.imu.Imu;

/// Kinds of devices that publish readings, or what they show, if a robot has them, beside those that
/// [RobotPublications] itself knows.
final class SensorPublications {
    private static final List<Kind<?>> ALL = List.of(
            new Kind<>(Imu.class, ImuPublication::begin),
            new Kind<>(Gripper.class, GripperPublication::begin),
            new Kind<>(BlobFinder.class, BlobsPublication::begin),
            new Kind<>(Bumper.class, BumperPublication::begin),
            new Kind<>(Camera.class, CameraPublication::begin),
            new Kind<>(Navigator.class, PlanPublication::begin));

    private SensorPublications() {}

    /// Publishes what a device reads, until the outlet is closed.
    interface Beginning<D extends Device> {
        void begin(D device, RobotOutlet outlet);
    }

    private record Kind<D extends Device>(Class<D> type, Beginning<D> beginning) {
        void begin(Device device, RobotOutlet outlet) {
            if (type.isInstance(device)) {
                beginning.begin(type.cast(device), outlet);
            }
        }
    }

    /// A device of no such kind publishes nothing.
    static void begin(Device device, RobotOutlet outlet) {
        ALL.forEach(kind -> kind.begin(device, outlet));
    }
}
