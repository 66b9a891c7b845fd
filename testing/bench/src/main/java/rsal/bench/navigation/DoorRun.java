package rsal.bench.navigation;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import rsal.bench.place.Floorplan;
import rsal.bench.place.NavigatedPioneers;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;

/// Four Pioneers, two in each of two rooms, whom a door of 0.8 m joins. Each is sent to the other room, and back, and
/// so on.
final class DoorRun implements AutoCloseable {
    private static final Duration PERIOD = Duration.ofMillis(500);
    private static final double WALL = 5; // m; x of it
    private static final OccupancyGrid ROOMS =
            Floorplan.room(10, 6).with(4.9, 0, 5.1, 2.6).with(4.9, 3.4, 5.1, 6).grid();
    private static final List<Pose2d> STARTS =
            List.of(new Pose2d(2, 2, 0), new Pose2d(2, 4, 0), new Pose2d(8, 2, Math.PI), new Pose2d(8, 4, Math.PI));
    private static final Tolerance NEAR = Tolerance.position(0.4); // m
    private static final double APART = 1.2; // m, between goals

    private final NavigatedPioneers pioneers;
    private final SplittableRandom random;
    private final Map<String, Point2d> goals = new HashMap<>();
    private int reached;

    /// @param planner the navigators' local one
    DoorRun(String planner, long seed) {
        random = new SplittableRandom(seed);
        pioneers = new NavigatedPioneers(
                ROOMS, ROOMS, STARTS, Map.of("controller", planner), seed, random.split(), Runnable::run);
        pioneers.robots.forEach(
                robot -> goals.put(robot.id(), pioneers.truth(robot).position()));
    }

    void run(Duration length) {
        while (pioneers.time.elapsed().compareTo(length) < 0) {
            pioneers.robots.stream()
                    .filter(robot -> NavigatedPioneers.navigator(robot).goal().isEmpty())
                    .forEach(this::sendAcross);
            pioneers.time.advance(PERIOD);
        }
    }

    private void sendAcross(Robot robot) {
        boolean toTheRight = pioneers.truth(robot).x() < WALL;
        goals.remove(robot.id());
        Point2d goal;
        do {
            double fromDoor = random.nextDouble(1.5, 4);
            goal = new Point2d(toTheRight ? WALL + fromDoor : WALL - fromDoor, random.nextDouble(1, 5));
        } while (isTaken(goal));
        goals.put(robot.id(), goal);
        NavigatedPioneers.navigator(robot)
                .goTo(new Pose2d(goal.x(), goal.y(), 0), NEAR)
                .result()
                .thenAccept(result -> reached += result instanceof Result.Reached ? 1 : 0);
    }

    private boolean isTaken(Point2d place) {
        return goals.values().stream().anyMatch(other -> other.distanceTo(place) < APART);
    }

    /// How many goals were reached.
    int reached() {
        return reached;
    }

    /// How often robots touched something.
    int contacts() {
        return pioneers.contacts();
    }

    @Override
    public void close() {
        pioneers.close();
    }
}
