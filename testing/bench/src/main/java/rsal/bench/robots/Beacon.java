package rsal.bench.robots;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.SensorCore;
import rsal.device.SonarArray;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.time.Scheduler;
import rsal.time.Task;

/// A robot that stands still, and whose readings say what nobody else could know who gets them: when they were told,
/// and which of all they are. Called on the scheduler's thread, unless it says otherwise.
final class Beacon {
    private static final Part.Laser SCANNER = WanderingRobots.Kind.laser(180, 8);
    private static final Part.Sonars SONARS = WanderingRobots.Kind.ring(16, 0.22, 5);

    /// A base, a laser of 180 beams and 16 sonars.
    static final RobotModel MODEL = new RobotModel(
            "beacon",
            "Beacon",
            WanderingRobots.Kind.LASER180.model().body(),
            WanderingRobots.Kind.LASER180.model().drive(),
            Map.of("laser", SCANNER, "sonar", SONARS));

    private static final int ROUND = 1000; // readings, after which their numbers begin again
    private static final double OFFSET = 1; // of what ranges say, as nothing is nearer than 0 [m]

    private final Robot robot;
    private final Base base;
    private final Laser laser;
    private final Ring ring;
    private @Nullable Task telling;
    private int told;

    /// What a reading says.
    ///
    /// @param at [Beacons#now]
    /// @param number from 0, less than [#ROUND]
    record Mark(double at, int number) {
        static Mark of(Odometry odometry) {
            Pose2d pose = odometry.odomFromBase();
            return new Mark(pose.x(), (int) pose.y());
        }

        /// By the first two of them.
        static Mark of(float[] ranges) {
            return new Mark(ranges[0] - OFFSET, (int) Math.round((ranges[1] - OFFSET) * ROUND));
        }

        private Odometry odometry() {
            return new Odometry(new Pose2d(at, number, 0), Twist2d.STOP, false);
        }

        private float[] ranges(int count) {
            float[] ranges = new float[count];
            Arrays.fill(ranges, (float) OFFSET);
            ranges[0] += (float) at;
            ranges[1] += (float) number / ROUND;
            return ranges;
        }

        /// How many were told between another and this.
        int since(int other) {
            return Math.floorMod(number - other - 1, ROUND);
        }
    }

    Beacon(String id) {
        base = new Base(id);
        laser = new Laser(id);
        ring = new Ring(id);
        robot = new Robot(id, "beacon", MODEL, List.of(base, laser, ring));
    }

    Robot robot() {
        return robot;
    }

    /// Tells from now on.
    void begin(Duration delay, Duration period, Scheduler time) {
        telling = time.after(delay, () -> telling = time.every(period, () -> tell(time)));
    }

    /// Tells no more.
    ///
    /// @return the number of its last readings
    int end() {
        if (telling != null) {
            telling.cancel();
        }
        return (told - 1) % ROUND;
    }

    private void tell(Scheduler time) {
        int number = told++ % ROUND;
        base.tell(new Mark(Beacons.now(), number), time);
        laser.tell(new Mark(Beacons.now(), number), time);
        ring.tell(new Mark(Beacons.now(), number), time);
    }

    private static DeviceInfo device(String robot, String name) {
        return new DeviceInfo(robot, name, "beacon");
    }

    private static final class Base extends SensorCore<Odometry> implements DriveBase {
        private boolean enabled = true;

        Base(String robot) {
            super(device(robot, "base"));
        }

        void tell(Mark mark, Scheduler time) {
            deliver(new Stamped<>(time.instant(), info().robot() + "/odom", mark.odometry()));
        }

        @Override
        public void command(Twist2d velocity) {} // it stands

        @Override
        public void enable(boolean enabled) {
            this.enabled = enabled;
        }

        @Override
        public boolean enabled() {
            return enabled;
        }

        @Override
        public void resetOdometry(Pose2d odomFromBase) {
            throw new UnsupportedOperationException("It says when it is, not where.");
        }
    }

    private static final class Laser extends SensorCore<LaserScan> implements LaserScanner {
        Laser(String robot) {
            super(device(robot, "laser"));
        }

        void tell(Mark mark, Scheduler time) {
            var scan = new LaserScan(
                    SCANNER.baseFromLaser(),
                    SCANNER.angleMin(),
                    SCANNER.angleIncrement(),
                    SCANNER.rangeMin(),
                    SCANNER.rangeMax(),
                    mark.ranges(SCANNER.samples()));
            deliver(new Stamped<>(time.instant(), info().id(), scan));
        }
    }

    private static final class Ring extends SensorCore<RangeArray> implements SonarArray {
        Ring(String robot) {
            super(device(robot, "sonar"));
        }

        void tell(Mark mark, Scheduler time) {
            var ranges = new RangeArray(
                    SONARS.baseFromSensors(),
                    SONARS.fieldOfView(),
                    SONARS.rangeMin(),
                    SONARS.rangeMax(),
                    mark.ranges(SONARS.baseFromSensors().size()));
            deliver(new Stamped<>(time.instant(), info().robot() + "/base_link", ranges));
        }
    }
}
