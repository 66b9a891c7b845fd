package rsal.bench.robots;

import java.time.Duration;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Device;
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
    private static final Part.Sonars SONARS = WanderingRobots.Kind.ring(16, 0.22, 5);

    /// What it has.
    @SuppressWarnings("ImmutableEnumChecker") // models are records that nobody changes
    enum Kind {
        /// A base, a laser of 180 beams and 16 sonars, which tell equally often.
        PIONEER(1, WanderingRobots.Kind.laser(180, 8), Map.of("sonar", SONARS)),

        /// A base that tells twice as often as its laser of 360 beams.
        SCANNER(2, WanderingRobots.Kind.laser(360, 8), Map.of());

        private final int odometries; // for each scan
        private final Part.Laser laser;
        private final RobotModel model;

        Kind(int odometries, Part.Laser laser, Map<String, Part> others) {
            this.odometries = odometries;
            this.laser = laser;
            var parts = new LinkedHashMap<String, Part>(others);
            parts.put("laser", laser);
            RobotModel pattern = WanderingRobots.Kind.LASER180.model();
            model = new RobotModel("beacon", "Beacon", pattern.body(), pattern.drive(), parts);
        }

        RobotModel model() {
            return model;
        }
    }

    private static final int ROUND = 1000; // readings, after which their numbers begin again
    private static final double OFFSET = 1; // of what ranges say, as nothing is nearer than 0 [m]

    private final Kind kind;
    private final Robot robot;
    private final Base base;
    private final Laser laser;
    private final Ring ring;
    private @Nullable Task publishing;
    private int ticks;
    private int reported; // odometries

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

    Beacon(String id, Kind kind) {
        this.kind = kind;
        base = new Base(id);
        laser = new Laser(id, kind.laser);
        ring = new Ring(id);
        List<Device> devices =
                kind.model.sensors().containsKey("sonar") ? List.of(base, laser, ring) : List.of(base, laser);
        robot = new Robot(id, "beacon", kind.model, devices);
    }

    Robot robot() {
        return robot;
    }

    /// Tells from now on.
    ///
    /// @param period of its scans
    void begin(Duration delay, Duration period, Scheduler time) {
        Duration tick = period.dividedBy(kind.odometries);
        publishing = time.after(delay, () -> publishing = time.every(tick, () -> publish(time)));
    }

    /// Tells no more.
    ///
    /// @return the number of its last scan
    int end() {
        if (publishing != null) {
            publishing.cancel();
        }
        return Math.floorMod(reported - 1, ROUND);
    }

    /// Readings of one time have one number, so that odometries between two scans have that of the scan before.
    private void publish(Scheduler time) {
        if (ticks++ % kind.odometries == 0) {
            int number = reported++ % ROUND;
            laser.publish(new Mark(Beacons.now(), number), time);
            ring.publish(new Mark(Beacons.now(), number), time);
        }
        base.publish(new Mark(Beacons.now(), (reported - 1) % ROUND), time);
    }

    private static DeviceInfo device(String robot, String name) {
        return new DeviceInfo(robot, name, "beacon");
    }

    private static final class Base extends SensorCore<Odometry> implements DriveBase {
        private boolean enabled = true;

        Base(String robot) {
            super(device(robot, "base"));
        }

        void publish(Mark mark, Scheduler time) {
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
        private final Part.Laser scanner;

        Laser(String robot, Part.Laser scanner) {
            super(device(robot, "laser"));
            this.scanner = scanner;
        }

        void publish(Mark mark, Scheduler time) {
            var scan = new LaserScan(
                    scanner.baseFromLaser(),
                    scanner.angleMin(),
                    scanner.angleIncrement(),
                    scanner.rangeMin(),
                    scanner.rangeMax(),
                    mark.ranges(scanner.samples()));
            deliver(new Stamped<>(time.instant(), info().id(), scan));
        }
    }

    private static final class Ring extends SensorCore<RangeArray> implements SonarArray {
        Ring(String robot) {
            super(device(robot, "sonar"));
        }

        void publish(Mark mark, Scheduler time) {
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
