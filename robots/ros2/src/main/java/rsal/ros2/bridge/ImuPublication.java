package rsal.ros2.bridge;

import rsal.data.Stamped;
import rsal.device.imu.Imu;
import rsal.device.imu.ImuKind;
import rsal.device.imu.ImuReading;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.RosMessages;
import rsal.settings.Arguments;

/// An IMU as `sensor_msgs/Imu` (REP 145): with gravity in its acceleration, as its accelerometer stands level.
/// Covariances are those of the part's noise; 0 where they are unknown.
final class ImuPublication {
    private static final double GRAVITY = 9.80665; // m/s², upwards: what holds it against falling
    private static final int COVARIANCES = 9;

    private final CdrWriter writer = new CdrWriter();
    private final RobotOutlet outlet;
    private final double[] orientationCovariance = new double[COVARIANCES];
    private final double[] velocityCovariance = new double[COVARIANCES];
    private final double[] accelerationCovariance = new double[COVARIANCES];

    private ImuPublication(RobotOutlet outlet) {
        this.outlet = outlet;
    }

    static void begin(Imu imu, RobotOutlet outlet) {
        String name = imu.info().name();
        var publication = new ImuPublication(outlet);
        Publication readings =
                outlet.advertise(imu, outlet.name(imu, Imu.class, "imu"), "sensor_msgs/msg/Imu", Profile.DEFAULT);
        if (outlet.robot().model().sensors().get(name) instanceof Part.Registered part) {
            publication.learn(part);
            outlet.keep(imu.subscribe(reading -> {
                if (outlet.mount(reading.time(), name, part.baseFromDevice())) {
                    outlet.publishMounts(reading.time());
                }
            }));
        }
        String frame = outlet.frames().sensor(name);
        outlet.keep(imu.subscribe(reading -> readings.publish(publication.message(reading, frame))));
    }

    /// White noise of density σ has, over a time Δt, a variance of σ² / Δt.
    private void learn(Part.Registered part) {
        Arguments noise = part.arguments();
        double seconds = part.period().toNanos() / 1e9;
        if (part.kind() instanceof ImuKind && seconds > 0) {
            fill(orientationCovariance, noise.get(ImuKind.COMPASS) ? noise.radians(ImuKind.COMPASS_NOISE) : 0);
            fill(velocityCovariance, noise.radians(ImuKind.GYROSCOPE_NOISE) / Math.sqrt(seconds));
            fill(accelerationCovariance, noise.get(ImuKind.ACCELEROMETER_NOISE) / Math.sqrt(seconds));
        }
    }

    private static void fill(double[] covariance, double deviation) {
        for (int axis = 0; axis < 3; axis++) {
            covariance[axis * 4] = deviation * deviation;
        }
    }

    private byte[] message(Stamped<ImuReading> stamped, String frame) {
        ImuReading reading = stamped.value();
        double half = reading.orientation() / 2;
        RosMessages.write(writer.clear(), outlet.stamp(stamped.time())).text(frame);
        writer.float64(0).float64(0).float64(Math.sin(half)).float64(Math.cos(half));
        writer.float64s(orientationCovariance);
        writer.float64(0).float64(0).float64(reading.angularVelocity());
        writer.float64s(velocityCovariance);
        writer.float64(reading.accelerationX()).float64(reading.accelerationY()).float64(GRAVITY);
        return writer.float64s(accelerationCovariance).toBytes();
    }
}
