package rsal.agent.platform;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rsal.data.Footprint;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.SensorCore;
import rsal.robot.Robot;
import rsal.robot.RobotModel;

/// A robot with a base that a test reads and moves by hand.
final class BaseRobot {
    final Base base = new Base();
    final Robot robot = new Robot(
            "r1",
            "rover",
            new RobotModel(
                    "fake",
                    "Fake",
                    Footprint.box(0.4, 0.4, new Point2d(0, 0)),
                    new RobotModel.Drive(1, 2, 1, 2, new RobotModel.OdometryNoise(0, 0, 0)),
                    Map.of()),
            List.of(base));

    static final class Base extends SensorCore<Odometry> implements DriveBase {
        final List<Twist2d> commands = new ArrayList<>();

        Base() {
            super(new DeviceInfo("r1", "base", "fake"));
        }

        /// Tells that the robot has come so far [m].
        void rollTo(double x, Instant time) {
            deliver(new Stamped<>(time, "r1/odom", new Odometry(new Pose2d(x, 0, 0), Twist2d.STOP, false)));
        }

        @Override
        public void command(Twist2d velocity) {
            commands.add(velocity);
        }

        @Override
        public void enable(boolean enabled) {}

        @Override
        public boolean enabled() {
            return true;
        }

        @Override
        public void resetOdometry(Pose2d odomFromBase) {}
    }
}
