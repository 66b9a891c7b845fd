package rsal.cli.log;

import java.io.PrintWriter;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.cli.log.MapResult.Bent;
import rsal.cli.log.MapResult.Drawn;
import rsal.cli.log.MapResult.Errors;
import rsal.cli.log.MapResult.Merged;
import rsal.cli.log.MapResult.Residuals;
import rsal.data.Pose2d;
import rsal.navigation.slam.FreeSpaceViolation;
import rsal.navigation.slam.GraphResidual;
import rsal.navigation.slam.MapOverlap;
import rsal.navigation.slam.Slam;
import rsal.scenario.text.Counted;

/// Says for people what became of logs, and warns of maps that are probably wrong.
final class MapReport {
    private final PrintWriter out;
    private final PrintWriter err;

    MapReport(PrintWriter out, PrintWriter err) {
        this.out = out;
        this.err = err;
    }

    /// Warns of a map that is probably wrong.
    void warn(MapResult result, Slam slam, GraphResidual residual, Optional<FreeSpaceViolation> contradiction) {
        result.logs().forEach(this::warn);
        result.merged().stream().filter(Merged::tooLarge).forEach(this::warn);
        contradiction.filter(FreeSpaceViolation::isTooMuch).ifPresent(most -> warn(most, slam));
        residual.tooLarge().ifPresent(step -> warn(step, slam));
    }

    void print(MapResult result) {
        for (Drawn log : result.logs()) {
            out.println("%s: %s, %d kept, %s known again"
                    .formatted(
                            log.log(), Counted.of(log.scans(), "scan"), log.kept(), Counted.of(log.loops(), "place")));
            print("wheels, scan to scan", log.odometry());
            print("map, scan to scan", log.next());
            print("map, scans within %.0f m".formatted(MapResult.NEAR), log.near());
        }
        for (Merged one : result.merged()) {
            out.println(
                    ("%s lies at %.2f m, %.2f m, %.1f° in the map of %s: both saw %.0f m² of floor, %.2f%% of what was"
                                    + " hit there stands in what the other saw free, %.0f%% of the beams go through walls")
                            .formatted(
                                    one.log(),
                                    one.x(),
                                    one.y(),
                                    one.degrees(),
                                    result.logs().getFirst().log(),
                                    one.squareMeters(),
                                    100 * one.against(),
                                    100 * one.throughWalls()));
            if (one.tooLarge() && one.worst() != null) {
                out.println("  they contradict each other: %.2f%% is more than %.1f%%, most of it %s"
                        .formatted(
                                100 * one.against(),
                                100 * MapOverlap.MOST_AGAINST,
                                one.worst().words()));
            }
        }
        if (result.residual() != null) {
            print(result.residual());
        }
        if (result.contradiction() != null) {
            out.println("  %-24s %.0f%% of the beams (scan %d to %d)"
                    .formatted(
                            "through walls, at most",
                            100 * result.contradiction().share(),
                            result.contradiction().from(),
                            result.contradiction().to()));
        }
        out.println("%d × %d cells of %s m, %.1f s"
                .formatted(result.columns(), result.rows(), result.resolution(), result.seconds()));
        result.files().forEach(out::println);
        out.flush();
    }

    private void warn(GraphResidual.Step step, Slam slam) {
        Pose2d place = slam.poses().get(step.to());
        err.println(("The map is probably wrong: at (%.1f, %.1f), from keyframe %d to %d, it differs from all"
                        + " measurements of the robot's path by at least %.2f m and %.0f°, %.0f times their error. Maybe"
                        + " places that look alike were taken for one: look at picture.png, and map the log in parts."
                        + " Or the robot was carried there; then the map may be right.")
                .formatted(
                        place.x(),
                        place.y(),
                        step.from(),
                        step.to(),
                        step.meters(),
                        Math.toDegrees(step.radians()),
                        step.deviations()));
    }

    private void warn(Merged one) {
        err.println(("The map is probably wrong: '%s' contradicts what it was joined to, %s. Maybe these are two"
                        + " places that look alike, or something was moved there between the runs; then the map may be"
                        + " right.")
                .formatted(one.log(), LogMapper.against(one.against(), Optional.ofNullable(one.worst()))));
    }

    private void warn(Drawn log) {
        if (log.turns() != null && log.turns().reversed()) {
            err.println(("The map is probably mirrored: at %d of %d turns of '%s' scans say that the robot turned the"
                            + " other way than its wheels do. Maybe the laser is mounted upside down: try --upside-down.")
                    .formatted(log.turns().opposed(), log.turns().count(), log.log()));
        }
    }

    private void warn(FreeSpaceViolation most, Slam slam) {
        Pose2d from = slam.poses().get(most.from());
        Pose2d to = slam.poses().get(most.to());
        err.println(("The map is probably wrong: from (%.1f, %.1f) to (%.1f, %.1f), keyframes %d to %d,"
                        + " %.0f%% of the beams go through what others saw as walls, so parts of the place were laid onto"
                        + " each other. Maybe the robot was carried, or places that look alike were taken for one: look"
                        + " at picture.png, and map the log in parts.")
                .formatted(from.x(), from.y(), to.x(), to.y(), most.from(), most.to(), 100 * most.share()));
    }

    private void print(Residuals residual) {
        print("wheels, at most", residual.wheels());
        print("scans, at most", residual.scans());
        print("all of them, at least", residual.all());
        if (residual.blind() > 0) {
            out.println("  no scan confirms %d of %d steps: there the map is only as accurate as the odometry"
                    .formatted(residual.blind(), residual.steps()));
        }
    }

    private void print(String what, @Nullable Bent bent) {
        if (bent != null) {
            out.println("  %-24s bent by %.2f m, %.1f°, %.1f deviations (scan %d to %d)"
                    .formatted(what, bent.meters(), bent.degrees(), bent.deviations(), bent.from(), bent.to()));
        }
    }

    private void print(String what, @Nullable Errors errors) {
        if (errors != null) {
            out.println("  %-24s off %.3f m, %.2f° (%d relations)"
                    .formatted(what, errors.meters(), errors.degrees(), errors.relations()));
        }
    }
}
