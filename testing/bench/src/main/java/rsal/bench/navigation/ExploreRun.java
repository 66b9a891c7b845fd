package rsal.bench.navigation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import java.util.stream.Stream;
import rsal.bench.place.Office;
import rsal.bench.place.Pioneers;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Mapper;
import rsal.device.SimulationControl;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.NavigationFunction;
import rsal.navigation.wavefront.Wavefront;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.system.RobotSystem;
import rsal.time.LockstepScheduler;

/// Pioneers that map the office floor together, from scratch and from places of their own.
final class ExploreRun implements AutoCloseable {
    private static final Clearance ROOM = new Clearance(0.35, 0.7, 3); // m; where a robot can be
    private static final double SLACK = 0.5; // m
    private static final Duration STEP = Duration.ofSeconds(15);

    private final LockstepScheduler time;
    private final RobotSystem system;
    private final SimulationControl truth;
    private final List<Robot> robots = new ArrayList<>();
    private final CostMap costs = CostMap.of(Office.MAP, DistanceField.toNotFree(Office.MAP), ROOM);
    private final NavigationFunction reachable;

    /// @param minutes of the run
    /// @param share of the places where robots can be that are known to be free
    record Reached(double minutes, double share) {}

    ExploreRun(int count, long seed, Executor workers) {
        time = new LockstepScheduler(Instant.EPOCH, workers);
        var random = new SplittableRandom(seed);
        var starts = new ArrayList<Pose2d>();
        while (starts.size() < count) {
            Pose2d start = Office.place(random, costs::isPassable);
            if (starts.stream().allMatch(other -> other.distanceTo(start) > 1)) {
                starts.add(start);
            }
        }
        reachable = new Wavefront(costs)
                .everywhere(starts.getFirst().position(), SLACK)
                .orElseThrow();
        system = Pioneers.open(Office.MAP, starts, Pioneers.LASER, seed, time);
        truth = system.simulation().orElseThrow();
        // the same for all, or each would explore alone
        List<DeviceDriver> drivers =
                Stream.of("slam", "navigator", "explorer").map(Pioneers::driver).toList();
        for (Robot robot : system.discover().toCompletableFuture().join()) {
            Robot equipped = robot;
            for (DeviceDriver driver : drivers) {
                equipped =
                        Pioneers.equip(equipped, driver, Map.of(), Office.MAP, truth.truth(robot.id()), time, random);
            }
            robots.add(equipped);
        }
    }

    /// Lets them go on until they have mapped so much, or for so long.
    ///
    /// @return how they got on, every quarter of a minute
    List<Reached> run(double enough, double minutes) {
        var course = new ArrayList<Reached>();
        course.add(new Reached(0, 0));
        while (course.getLast().share() < enough && course.getLast().minutes() < minutes) {
            time.advance(STEP);
            course.add(new Reached(time.elapsed().toMillis() / 60e3, share()));
        }
        return course;
    }

    private double share() {
        return robots.getFirst()
                .require(Mapper.class)
                .latest()
                .map(Stamped::value)
                .map(this::share)
                .orElse(0.0);
    }

    private double share(OccupancyGrid map) {
        int all = 0;
        int known = 0;
        for (int cell = 0; cell < Office.MAP.cells().length; cell++) {
            Point2d place = Office.MAP.middle(cell);
            if (reachable.cost(place) < Double.POSITIVE_INFINITY) {
                all++;
                known += map.isFree(place.x(), place.y()) ? 1 : 0;
            }
        }
        return (double) known / all;
    }

    /// How often robots touched something.
    int contacts() {
        return truth.contacts().size();
    }

    @Override
    public void close() {
        system.close();
    }
}
