package rsal.cli.log;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.navigation.log.RobotLog;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.slam.FreeSpaceViolation;
import rsal.navigation.slam.GraphResidual;
import rsal.navigation.slam.MapOverlap;
import rsal.navigation.slam.RelationError;
import rsal.navigation.slam.TurnAgreement;

/// What `rsal map` has made of logs, as it is printed as JSON.
///
/// @param merged the logs after the first
/// @param columns of the map
/// @param rows of the map
/// @param residual null when poses were known
/// @param contradiction null when poses were known, and when there were too few scans to tell
record MapResult(
        List<Drawn> logs,
        List<Merged> merged,
        @Nullable Residuals residual,
        @Nullable ThroughWalls contradiction,
        int columns,
        int rows,
        double resolution,
        double seconds,
        List<String> files) {
    static final double NEAR = 2; // m; relations between poses that do not follow on each other

    /// Errors against poses that are right.
    ///
    /// @param relations looked at
    /// @param meters mean
    /// @param degrees mean
    record Errors(int relations, double meters, double degrees) {
        static Optional<Errors> of(RelationError error) {
            return error.count() == 0
                    ? Optional.empty()
                    : Optional.of(new Errors(error.count(), error.meters(), Math.toDegrees(error.radians())));
        }
    }

    /// What became of a log.
    ///
    /// @param kept scans in the graph
    /// @param loops places known again
    /// @param odometry error of the wheels from a scan to the next; null when nothing tells
    /// @param next error of the map from a scan to the next; null when nothing tells
    /// @param near error between scans near each other that do not follow on each other
    /// @param turns at which both wheels and scans tell; null when poses were known
    /// @param wandering null when the laser stays where it is mounted
    record Drawn(
            String log,
            int scans,
            int omitted,
            Map<String, Integer> skipped,
            int kept,
            long loops,
            @Nullable Errors odometry,
            @Nullable Errors next,
            @Nullable Errors near,
            @Nullable Turned turns,
            @Nullable Wandered wandering) {
        /// Of a log whose poses are right.
        static Drawn ofKnownPoses(String file, RecordedDrive drive, RobotLog log) {
            return new Drawn(
                    file,
                    drive.stops().size(),
                    drive.omitted(),
                    log.skipped().counts(),
                    drive.stops().size(),
                    0,
                    null,
                    null,
                    null,
                    null,
                    Wandered.of(log));
        }
    }

    /// Whether scans say that the robot turned as its wheels do.
    ///
    /// @param count of steps at which both tell
    /// @param opposed of them, at which they turned different ways
    /// @param reversed whether that is so at most of them, as with a laser that is upside down
    record Turned(int count, int opposed, boolean reversed) {
        static Turned of(TurnAgreement turns) {
            return new Turned(turns.count(), turns.opposed(), turns.isReversed());
        }
    }

    /// How far a laser moves on its robot, as a log has it: its poses were taken for corrected ones of the
    /// robot.
    record Wandered(double meters, double degrees) {
        static @Nullable Wandered of(RobotLog log) {
            return log.wandering()
                    .map(by -> new Wandered(by.meters(), Math.toDegrees(by.radians())))
                    .orElse(null);
        }
    }

    /// A step of a robot's way, by numbers of the scans that were kept, and how far the map is off what wheels
    /// or scans say of it.
    ///
    /// @param deviations in standard deviations of what wheels or scans say
    record Bent(int from, int to, double meters, double degrees, double deviations) {
        static @Nullable Bent of(Optional<GraphResidual.Step> step) {
            return step.map(s -> new Bent(s.from(), s.to(), s.meters(), Math.toDegrees(s.radians()), s.deviations()))
                    .orElse(null);
        }
    }

    /// How much the map bends what it was told.
    ///
    /// @param wheels the step that is farthest off what the wheels say
    /// @param scans the step that is farthest off what scans say
    /// @param all the step that is farthest off all that wheels and scans say
    /// @param tooLarge whether that is so far that the map is probably wrong
    /// @param steps of the way
    /// @param blind of them, told by wheels alone
    record Residuals(
            @Nullable Bent wheels,
            @Nullable Bent scans,
            @Nullable Bent all,
            boolean tooLarge,
            int steps,
            int blind) {
        static Residuals of(GraphResidual residual) {
            return new Residuals(
                    Bent.of(residual.wheels()),
                    Bent.of(residual.scans()),
                    Bent.of(residual.all()),
                    residual.tooLarge().isPresent(),
                    residual.steps(),
                    residual.blind());
        }
    }

    /// Beams that go through what other scans saw as walls.
    ///
    /// @param share of the beams of the scans from one to another, where it is most
    /// @param from number of the first of these, of those that were kept
    /// @param to number of the last
    /// @param tooLarge whether that is so much that the map is probably wrong there
    record ThroughWalls(double share, int from, int to, boolean tooLarge) {
        static @Nullable ThroughWalls of(Optional<FreeSpaceViolation> most) {
            return most.map(c -> new ThroughWalls(c.share(), c.from(), c.to(), c.isTooMuch()))
                    .orElse(null);
        }
    }

    /// Where the map of a log lies in that of the first, and what spoke for it when it was joined to those
    /// before it.
    ///
    /// @param x of its frame in that of the first, now that all are joined [m]
    /// @param y of its frame in that of the first [m]
    /// @param degrees heading of its frame in that of the first
    /// @param squareMeters of floor that both saw
    /// @param against share of the cells hit by either, within that floor, that the other saw as free
    /// @param tooLarge whether that is so much that they are joined only as that was asked for
    /// @param worst where most of that is; null when there is none
    /// @param throughWalls share of the beams of either that go through what the other hit
    record Merged(
            String log,
            double x,
            double y,
            double degrees,
            double squareMeters,
            double against,
            boolean tooLarge,
            @Nullable Clash worst,
            double throughWalls) {
        static Merged of(String log, Pose2d at, MapOverlap shared, @Nullable Clash worst) {
            return new Merged(
                    log,
                    at.x(),
                    at.y(),
                    Math.toDegrees(at.theta()),
                    shared.squareMeters(),
                    shared.against(),
                    shared.isContradicted(),
                    worst,
                    shared.through());
        }
    }

    /// A place in the first log's map where one log saw something stand, and another free floor.
    ///
    /// @param hitBy that log
    /// @param freeBy the other
    record Clash(double x, double y, String hitBy, String freeBy) {
        String words() {
            return "at (%.1f, %.1f), where '%s' hit what '%s' saw free".formatted(x, y, hitBy, freeBy);
        }
    }
}
