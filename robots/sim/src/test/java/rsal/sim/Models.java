package rsal.sim;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;

/// Robots to test with.
final class Models {
    static final OdometryNoise NO_NOISE = new OdometryNoise(0, 0, 0);
    static final Drive DRIVE = new Drive(0.8, 2, 0.5, 3, NO_NOISE);

    /// Front, left and right.
    static final Part.Sonars SONARS = new Part.Sonars(
            "sonar",
            List.of(new Pose2d(0.1, 0, 0), new Pose2d(0, 0.1, Math.PI / 2), new Pose2d(0, -0.1, -Math.PI / 2)),
            Math.toRadians(30),
            0.1,
            5,
            RangeNoise.of(0),
            Duration.ofMillis(100));

    private Models() {}

    static Part.Laser laser(double noise, Duration period) {
        return laser(RangeNoise.of(noise), period);
    }

    static Part.Laser laser(RangeNoise noise, Duration period) {
        return new Part.Laser("laser", new Pose2d(0.1, 0, 0), -Math.PI / 2, Math.PI / 180, 181, 0.05, 8, noise, period);
    }

    /// 0.5 m × 0.4 m.
    static RobotModel box(Drive drive, Part... parts) {
        var sensors = new LinkedHashMap<String, Part>();
        for (Part part : parts) {
            sensors.put(part.name(), part);
        }
        return new RobotModel("box", "Box", Footprint.box(0.5, 0.4, new Point2d(0, 0)), drive, sensors);
    }

    static RobotModel box() {
        return box(DRIVE, laser(0, Duration.ofMillis(100)), SONARS);
    }
}
