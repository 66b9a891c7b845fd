package rsal.bench.navigation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import rsal.bench.place.Office;
import rsal.bench.place.Pioneers;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.device.SimulationControl;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;
import rsal.robot.Robot;
import rsal.system.RobotSystem;
import rsal.time.LockstepScheduler;

/// A simulated Pioneer on the office floor that is sent from one random place to the next by somebody who sees where
/// it really is, while its device `amcl` says where it believes to be.
final class SimulatedDrive {
    private static final Duration PERIOD = Duration.ofMillis(100);
    private static final double SPEED = 0.5; // m/s
    private static final double PASSED = 0.15; // m, from a point of the way
    private static final double TURN = 2; // rad/s by radian
    private static final double AHEAD = 0.5; // rad; what is farther aside is turned to first
    private static final int HELD_UP = 30; // periods without a move
    private static final Wavefront WAYS =
            new Wavefront(CostMap.of(Office.MAP, DistanceField.toNotFree(Office.MAP), new Clearance(0.32, 0.6, 2)));
    private static final Point2d CORRIDOR = new Point2d(0, -1.2);

    private final List<Reported> reported = new ArrayList<>();
    private final Deque<Point2d> way = new ArrayDeque<>();
    private final SplittableRandom random;
    private Pose2d before = Pose2d.ORIGIN;
    private int held;

    /// What the robot said, and where it was when it measured that.
    record Reported(PoseEstimate estimate, Pose2d truth) {}

    private SimulatedDrive(long seed) {
        random = new SplittableRandom(seed);
    }

    /// @param sensors what sits at the mounts of the Pioneer
    /// @param periods of a tenth of a second
    static List<Reported> run(Map<String, String> sensors, long seed, int periods) {
        var drive = new SimulatedDrive(seed);
        drive.go(sensors, seed, periods);
        return drive.reported;
    }

    private void go(Map<String, String> sensors, long seed, int periods) {
        var time = new LockstepScheduler(Instant.EPOCH, Runnable::run);
        Pose2d start = place();
        try (RobotSystem system = Pioneers.open(Office.MAP, List.of(start), sensors, seed, time)) {
            SimulationControl simulation = system.simulation().orElseThrow();
            Robot robot = Pioneers.equip(
                    system.discover().toCompletableFuture().join().getFirst(),
                    Pioneers.driver("amcl"),
                    Map.of(),
                    Office.MAP,
                    Optional.of(start),
                    time,
                    random);
            robot.require(Localizer.class).subscribe(estimate -> {
                requireNow(estimate, time.instant());
                reported.add(new Reported(
                        estimate.value(), simulation.truth(robot.id()).orElseThrow()));
            });
            for (int i = 0; i < periods; i++) {
                time.advance(PERIOD);
                Pose2d truth = simulation.truth(robot.id()).orElseThrow();
                robot.require(DriveBase.class).command(toward(truth));
            }
        }
    }

    private static void requireNow(Stamped<?> reading, Instant now) {
        if (!reading.time().equals(now)) {
            throw new IllegalStateException(
                    "What was measured at (%s) is told at (%s).".formatted(reading.time(), now));
        }
    }

    private Twist2d toward(Pose2d truth) {
        held = before.isNear(truth, 1e-3, 1e-3) ? held + 1 : 0;
        before = truth;
        if (held > HELD_UP) {
            way.clear();
            held = 0;
        }
        while (!way.isEmpty() && way.getFirst().distanceTo(truth.position()) < PASSED) {
            way.removeFirst();
        }
        while (way.isEmpty()) {
            if (WAYS.plan(truth.position(), place().position(), PASSED) instanceof Plan.Found found) {
                way.addAll(found.path().points());
            }
        }
        double bearing = truth.bearingTo(way.getFirst());
        double share = Math.max(0, 1 - Math.abs(bearing) / AHEAD);
        return Twist2d.drive(SPEED * share, Math.clamp(TURN * bearing, -1, 1));
    }

    private Pose2d place() {
        return Office.place(
                random, place -> WAYS.map().isPassable(place) && WAYS.plan(place, CORRIDOR, 0) instanceof Plan.Found);
    }
}
