package rsal.bench.navigation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import rsal.bench.place.NavigatedPioneers;
import rsal.bench.place.Office;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;
import rsal.robot.Robot;

/// Three Pioneers on the office floor, each sent from one random place to the next.
final class OfficeRun implements AutoCloseable {
    private static final int ROBOTS = 3;
    private static final double SPEED = 0.4; // m/s, the navigator's own highest
    private static final Clearance NARROW = new Clearance(0.3, 0.3, 0); // m; just so that the robot gets through
    private static final Clearance ROOMY = new Clearance(0.35, 0.35, 0); // m; where goals are
    private static final Point2d CORRIDOR = new Point2d(0, -1.2);
    private static final Duration PERIOD = Duration.ofMillis(100);

    private final NavigatedPioneers pioneers;
    private final Wavefront shortest;
    private final Wavefront roomy;
    private final SplittableRandom random;
    private final List<Errand> errands = new ArrayList<>();
    private final Map<String, Ride> rides = new HashMap<>();
    private int sent;

    /// A goal and how it ended.
    ///
    /// @param shortest time of the shortest way at full speed [s]
    /// @param seconds that it took
    /// @param roughness by how much the turn rate changed, summed up [rad/s]
    /// @param meters driven
    record Errand(Result result, double shortest, double seconds, double roughness, double meters) {
        boolean reached() {
            return result instanceof Result.Reached;
        }
    }

    /// How a robot drives.
    private static final class Ride {
        private double turnRate;
        private double turned; // changes of the turn rate, summed up [rad/s]
        private double meters;
        private Point2d at = new Point2d(Double.NaN, Double.NaN);

        void goOn(Odometry odometry, Pose2d pose) {
            double rate = odometry.velocity().omega();
            turned += Math.abs(rate - turnRate);
            turnRate = rate;
            double step = at.distanceTo(pose.position());
            meters += Double.isNaN(step) ? 0 : step;
            at = pose.position();
        }
    }

    /// @param settings of the navigators
    OfficeRun(Map<String, ?> settings, long seed, Executor workers) {
        random = new SplittableRandom(seed);
        var field = DistanceField.toNotFree(Office.MAP);
        shortest = new Wavefront(CostMap.of(Office.MAP, field, NARROW));
        roomy = new Wavefront(CostMap.of(Office.MAP, field, ROOMY));
        var starts = new ArrayList<Pose2d>();
        for (int i = 0; i < ROBOTS; i++) {
            starts.add(place());
        }
        pioneers = new NavigatedPioneers(Office.MAP, Office.MAP, starts, settings, seed, random, workers);
    }

    /// Somewhere on the floor from where there is a way to the corridor.
    private Pose2d place() {
        return Office.place(
                random, place -> roomy.map().isPassable(place) && roomy.plan(place, CORRIDOR, 0) instanceof Plan.Found);
    }

    /// Sends the robots about until so many goals have ended.
    List<Errand> run(int goals) {
        while (errands.size() < goals) {
            for (Robot robot : pioneers.robots) {
                if (NavigatedPioneers.navigator(robot).goal().isEmpty() && sent < goals) {
                    sent++;
                    send(robot);
                }
            }
            pioneers.time.advance(PERIOD);
            pioneers.robots.forEach(robot -> rides.computeIfAbsent(robot.id(), _ -> new Ride())
                    .goOn(robot.require(DriveBase.class).latest().orElseThrow().value(), pioneers.truth(robot)));
        }
        return List.copyOf(errands);
    }

    private void send(Robot robot) {
        Pose2d from = pioneers.truth(robot);
        Pose2d goal = place();
        double distance = switch (shortest.plan(from.position(), goal.position(), 0.2)) {
            case Plan.Found found -> found.path().length();
            case Plan.None _ -> from.distanceTo(goal);
        };
        Duration start = pioneers.time.elapsed();
        Ride ride = rides.computeIfAbsent(robot.id(), _ -> new Ride());
        double turnedBefore = ride.turned;
        double metersBefore = ride.meters;
        NavigatedPioneers.navigator(robot)
                .goTo(goal, Tolerance.DEFAULT)
                .result()
                .thenAccept(result -> {
                    double seconds = pioneers.time.elapsed().minus(start).toMillis() * 1e-3;
                    errands.add(new Errand(
                            result, distance / SPEED, seconds, ride.turned - turnedBefore, ride.meters - metersBefore));
                });
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
