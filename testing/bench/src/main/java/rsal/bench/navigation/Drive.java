package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import rsal.data.Angles;
import rsal.data.FreeSpace;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;

/// A robot that drives through a map from one place to the next, at 0.5 m/s and 10 steps a second, with wheels that
/// err, a laser or a ring of sonars: a recorded truth to localize against, without the cost of the simulator.
final class Drive {
    private static final double STEP = 0.05; // m, in a tenth of a second
    private static final double MOST_TURN = 0.12; // rad, the same
    private static final double RADIUS = 0.3; // m

    private static final int LASER_BEAMS = 181;
    private static final double LASER_RANGE = 8; // m
    private static final double LASER_NOISE = 0.02; // m
    private static final double SONAR_RANGE = 5; // m
    private static final double SONAR_NOISE = 0.02; // share of the range
    private static final double SONAR_CONE = Math.toRadians(30);
    private static final double MISSED = 0.01; // of all readings
    private static final double SHORT = 0.01; // of all readings, by people who are not on the map

    /// What the wheels of a usual robot add, as standard deviations.
    static final OdometryModel WHEELS = new OdometryModel(0.05, Math.toRadians(2), Math.toRadians(3));

    private final OccupancyGrid map;
    private final DistanceField walls;
    private final Wavefront planner;
    private final FreeSpace free;

    /// A step of a tenth of a second.
    record Tick(Pose2d mapFromBase, Pose2d odomFromBase) {}

    Drive(OccupancyGrid map) {
        this.map = map;
        this.walls = DistanceField.toOccupied(map);
        this.planner =
                new Wavefront(CostMap.of(map, DistanceField.toNotFree(map), new Clearance(RADIUS, 2 * RADIUS, 2)));
        this.free = new FreeSpace(map, RADIUS);
    }

    OccupancyGrid map() {
        return map;
    }

    /// Somewhere in the free space.
    Pose2d anywhere(RandomGenerator random) {
        return free.choose(random, _ -> true).orElseThrow();
    }

    private Point2d anywhere(RandomGenerator random, Predicate<Point2d> willDo) {
        Point2d place = anywhere(random).position();
        while (!willDo.test(place)) {
            place = anywhere(random).position();
        }
        return place;
    }

    /// To one random place after the other.
    List<Tick> tour(Pose2d start, int ticks, RandomGenerator random) {
        return tour(start, ticks, random, _ -> true);
    }

    /// To one random place after the other, of those that will do.
    List<Tick> tour(Pose2d start, int ticks, RandomGenerator random, Predicate<Point2d> willDo) {
        var truth = new ArrayList<Pose2d>();
        truth.add(start);
        while (truth.size() < ticks) {
            Pose2d last = truth.getLast();
            if (planner.plan(last.position(), anywhere(random, willDo), RADIUS) instanceof Plan.Found found) {
                follow(found.path(), truth, ticks);
            }
        }
        return withOdometry(truth, random);
    }

    /// There and back along a line.
    List<Tick> shuttle(Point2d from, Point2d to, int ticks, RandomGenerator random) {
        var truth = new ArrayList<Pose2d>();
        truth.add(new Pose2d(from.x(), from.y(), Math.atan2(to.y() - from.y(), to.x() - from.x())));
        for (boolean there = true; truth.size() < ticks; there = !there) {
            follow(new Path2d(List.of(there ? to : from)), truth, ticks);
        }
        return withOdometry(truth, random);
    }

    private static void follow(Path2d path, List<Pose2d> truth, int ticks) {
        for (Point2d next : path.points()) {
            while (truth.size() < ticks && truth.getLast().position().distanceTo(next) > STEP) {
                Pose2d pose = truth.getLast();
                double bearing = pose.bearingTo(next);
                double turn = Math.clamp(bearing, -MOST_TURN, MOST_TURN);
                double distance = Math.abs(bearing) > 0.5 ? 0 : STEP;
                truth.add(pose.compose(new Pose2d(0, 0, turn)).compose(new Pose2d(distance, 0, 0)));
            }
        }
    }

    private static List<Tick> withOdometry(List<Pose2d> truth, RandomGenerator random) {
        var ticks = new ArrayList<Tick>();
        Pose2d odometry = Pose2d.ORIGIN;
        for (int i = 0; i < truth.size(); i++) {
            odometry = i == 0 ? odometry : WHEELS.sample(odometry, truth.get(i - 1), truth.get(i), random);
            ticks.add(new Tick(truth.get(i), odometry));
        }
        return ticks;
    }

    /// The same with the robot carried elsewhere, where it goes on; its wheels notice nothing.
    static List<Tick> kidnapped(List<Tick> before, List<Tick> after) {
        var ticks = new ArrayList<>(before);
        Pose2d odometry = before.getLast().odomFromBase();
        Pose2d first = after.getFirst().odomFromBase();
        for (Tick tick : after) {
            Pose2d made = first.inverse().compose(tick.odomFromBase());
            ticks.add(new Tick(tick.mapFromBase(), odometry.compose(made)));
        }
        return ticks;
    }

    /// Half a turn to the front, 8 m.
    LaserScan laser(Pose2d mapFromBase, RandomGenerator random) {
        var ranges = new float[LASER_BEAMS];
        double increment = Math.PI / (LASER_BEAMS - 1);
        for (int i = 0; i < ranges.length; i++) {
            double direction = mapFromBase.theta() - Math.PI / 2 + i * increment;
            ranges[i] = (float) disturbed(
                    walls.castRay(mapFromBase.x(), mapFromBase.y(), direction, LASER_RANGE),
                    LASER_NOISE,
                    LASER_RANGE,
                    random);
        }
        return new LaserScan(Pose2d.ORIGIN, -Math.PI / 2, increment, 0.02, LASER_RANGE, ranges);
    }

    /// A ring of sonars, 5 m, each a cone of 30°.
    RangeArray sonars(Pose2d mapFromBase, int count, RandomGenerator random) {
        List<Pose2d> mounts = IntStream.range(0, count)
                .mapToObj(i -> Pose2d.polar(0.18, Angles.wrap((i + 0.5) * 2 * Math.PI / count)))
                .toList();
        var ranges = new float[count];
        for (int i = 0; i < count; i++) {
            Pose2d sonar = mapFromBase.compose(mounts.get(i));
            double nearest = SONAR_RANGE;
            for (int ray = -3; ray <= 3; ray++) {
                nearest = Math.min(
                        nearest,
                        walls.castRay(sonar.x(), sonar.y(), sonar.theta() + ray * SONAR_CONE / 6, SONAR_RANGE));
            }
            ranges[i] = (float) disturbed(nearest, SONAR_NOISE * nearest, SONAR_RANGE, random);
        }
        return new RangeArray(mounts, SONAR_CONE, 0.05, SONAR_RANGE, ranges);
    }

    private static double disturbed(double range, double noise, double limit, RandomGenerator random) {
        double chance = random.nextDouble();
        if (chance < MISSED || range >= limit) {
            return Double.POSITIVE_INFINITY;
        }
        double reported = chance < MISSED + SHORT ? range * random.nextDouble() : range + noise * random.nextGaussian();
        return Math.max(0.03, reported);
    }
}
