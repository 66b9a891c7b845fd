package rsal.navigation.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.Beams;

/// Follows a course with a particle filter, scan by scan.
public final class Replay {
    private Replay() {}

    /// What was believed once a scan had been looked at.
    ///
    /// @param nanos how long that took; of scans that were not due only what it took to see that
    /// @param due whether the robot had moved enough for the filter to look
    public record Step(RecordedDrive.Stop stop, PoseEstimate estimate, int particles, long nanos, boolean due) {
        /// How far the estimate is from where the robot was, if that is known [m].
        public Optional<Double> error() {
            return stop.mapFromBase().map(estimate.mapFromBase()::distanceTo);
        }

        /// The same of the heading, not less than 0 [rad].
        public Optional<Double> headingError() {
            return stop.mapFromBase()
                    .map(pose -> Math.abs(Angles.difference(
                            pose.theta(), estimate.mapFromBase().theta())));
        }
    }

    /// What the filter is shown of a scan.
    ///
    /// @param beams at most
    /// @param maxRange not beyond [m]
    public record Look(int beams, double maxRange) {}

    /// @param amcl started already, anywhere or from a pose
    /// @param nanos a clock to time updates with [ns]
    public static List<Step> run(RecordedDrive drive, Amcl amcl, Look look, LongSupplier nanos) {
        var steps = new ArrayList<Step>();
        PoseEstimate estimate = null;
        Pose2d odomFromBase = Pose2d.ORIGIN;
        int particles = 0;
        for (RecordedDrive.Stop stop : drive.stops()) {
            long before = nanos.getAsLong();
            Supplier<Beams> beams = () -> Beams.of(stop.scan(), look.beams(), look.maxRange());
            boolean due = estimate == null || amcl.due(stop.odomFromBase(), beams);
            if (estimate == null || due) {
                estimate = amcl.update(stop.odomFromBase(), beams.get());
                particles = amcl.particleCount();
            } else {
                estimate = estimate.moved(odomFromBase.inverse().compose(stop.odomFromBase()));
            }
            odomFromBase = stop.odomFromBase();
            steps.add(new Step(stop, estimate, particles, nanos.getAsLong() - before, due));
        }
        return steps;
    }
}
