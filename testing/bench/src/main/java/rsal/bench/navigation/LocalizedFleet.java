package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import rsal.bench.measurement.Stopwatch;
import rsal.bench.navigation.Drive.Tick;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.Amcl.Settings;
import rsal.navigation.amcl.Beams;
import rsal.navigation.amcl.LocalizationMap;

/// Robots on one map that each localize themselves, as the device `amcl` does it: odometry ten times a second moves
/// what is believed, each scan is offered to the filter, which looks at it when the robot has moved enough and then
/// tells its particles. What they see is known before, and costs nothing.
final class LocalizedFleet {
    private static final double TICK = 0.1; // s

    private final LocalizationMap map;
    private final List<Ride> rides = new ArrayList<>();
    private final int ticks;

    /// @param beams at each tick
    private record Ride(List<Tick> ticks, List<Beams> beams) {}

    /// A robot at work.
    private static final class Rider {
        private final Ride ride;
        private final Amcl amcl;
        private PoseEstimate belief;
        private Pose2d odomFromBase;

        Rider(Ride ride, Amcl amcl) {
            this.ride = ride;
            this.amcl = amcl;
            belief = LocalizationBench.about(ride.ticks.getFirst().mapFromBase());
            odomFromBase = ride.ticks.getFirst().odomFromBase();
            amcl.start(belief);
        }

        void go(int tick) {
            Pose2d odometry = ride.ticks.get(tick).odomFromBase();
            Supplier<Beams> beams = () -> ride.beams.get(tick);
            PoseEstimate reported = belief.moved(odomFromBase.inverse().compose(odometry));
            if (!reported.isFinite()) {
                throw new IllegalStateException("A robot is at '%s'.".formatted(reported));
            }
            if (amcl.due(odometry, beams)) {
                belief = amcl.update(odometry, beams.get());
                odomFromBase = odometry;
                amcl.particles();
            }
        }
    }

    /// @param map which all share
    /// @param ticks of a tenth of a second
    LocalizedFleet(Drive drive, LocalizationMap map, int robots, int ticks, Sense sense) {
        this.map = map;
        this.ticks = ticks;
        for (int robot = 1; robot <= robots; robot++) {
            var random = new SplittableRandom(robot);
            List<Tick> driven = drive.tour(drive.anywhere(random), ticks, random);
            List<Beams> beams = driven.stream()
                    .map(tick -> sense.look(tick.mapFromBase(), random))
                    .toList();
            rides.add(new Ride(driven, beams));
        }
    }

    /// Share of a core that all take, of this thread, in simulated time.
    double cores(Settings settings) {
        List<Rider> riders = rides.stream()
                .map(ride -> new Rider(ride, new Amcl(map, settings, new SplittableRandom(1))))
                .toList();
        var watch = new Stopwatch();
        for (int tick = 0; tick < ticks; tick++) {
            for (Rider rider : riders) {
                rider.go(tick);
            }
        }
        return watch.thread() / (ticks * TICK);
    }

    /// What a robot sees from a pose.
    interface Sense {
        Beams look(Pose2d mapFromBase, SplittableRandom random);
    }
}
