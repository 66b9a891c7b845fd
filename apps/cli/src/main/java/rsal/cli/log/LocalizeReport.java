package rsal.cli.log;

import java.io.PrintWriter;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.cli.log.LocalizeResult.RunView;
import rsal.cli.log.LocalizeResult.StepView;
import rsal.cli.log.LocalizeResult.Summary;
import rsal.data.PoseEstimate.Quality;
import rsal.navigation.replay.RecordedDrive;
import rsal.scenario.text.Counted;

/// Says for people how well a robot was localized.
final class LocalizeReport {
    private static final double MOSTLY = 0.3; // share of the scans, at which lost is worth a word

    private final PrintWriter out;
    private final PrintWriter err;

    LocalizeReport(PrintWriter out, PrintWriter err) {
        this.out = out;
        this.err = err;
    }

    /// @param steps whether each step is told, too
    void print(RunView run, boolean steps) {
        if (steps) {
            out.println(
                    "      time        x        y     deg  ± m ± deg   confidence             particles      ms  error m");
            for (StepView step : run.steps()) {
                out.println("%10.2f %8.2f %8.2f %7.1f %5.2f %5.1f %5.2f %-13s %9d %9.2f %8s"
                        .formatted(
                                step.time(),
                                step.x(),
                                step.y(),
                                Math.toDegrees(step.heading()),
                                Math.sqrt(step.covariance()[0] + step.covariance()[3]),
                                Math.toDegrees(Math.sqrt(step.covariance()[5])),
                                step.confidence(),
                                step.quality(),
                                step.particles(),
                                step.ms(),
                                meters(step.error())));
            }
        }
        out.println("seed %d: localized at %.0f%%, ambiguous at %.0f%%, lost at %.0f%% of %d scans"
                .formatted(
                        run.seed(),
                        100 * run.localized(),
                        100 * run.ambiguous(),
                        100 * run.lost(),
                        run.steps().size()));
        if (run.judged() > 0) {
            out.println(
                    run.convergedAfter() == null
                            ? "seed %d: never converged; falsely sure at %d of %d scans"
                                    .formatted(run.seed(), run.falselySure(), run.judged())
                            : ("seed %d: converged after %s; from there on rmse %s m%s, 95%% below %s m,"
                                            + " worst %s m; falsely sure at %d of %d scans")
                                    .formatted(
                                            run.seed(),
                                            Counted.of(run.convergedAfter(), "scan"),
                                            meters(run.rmse()),
                                            lostAgain(run.steps(), run.convergedAfter()),
                                            meters(run.p95()),
                                            meters(run.worst()),
                                            run.falselySure(),
                                            run.judged()));
        }
        out.flush();
    }

    /// ` (lost at 80% of these scans)`, where that is more than half; else nothing.
    ///
    /// @param converged at which of the scans, from 1, whose places are known
    private static String lostAgain(List<StepView> steps, int converged) {
        List<StepView> rest = steps.stream()
                .filter(step -> step.error() != null)
                .skip(converged - 1L)
                .toList();
        long lost = rest.stream()
                .filter(step -> step.quality().equals(StepView.word(Quality.LOST)))
                .count();
        return 2 * lost > rest.size() ? " (lost at %.0f%% of these scans)".formatted(100.0 * lost / rest.size()) : "";
    }

    /// What nobody should miss who looks at the last poses only.
    void printDoubts(String file, RecordedDrive drive, List<RunView> runs) {
        if (drive.omitted() > 0) {
            err.println("%s: %d of %d scans were skipped: the log has no odometry for them."
                    .formatted(
                            file,
                            drive.omitted(),
                            drive.omitted() + drive.stops().size()));
        }
        double lost = runs.stream().mapToDouble(RunView::lost).average().orElse(0);
        if (lost > MOSTLY) {
            err.println(
                    ("It was lost at %.0f%% of the scans. Maybe the map is of another place, or the laser is not where"
                                    + " the log says, or sees farther around than --field-of-view, or its"
                                    + " ranges are in other units than meters, or the map's scale is off.")
                            .formatted(100 * lost));
        }
        err.flush();
    }

    void print(Summary summary) {
        if (summary.seeds() > 1 && summary.judged() > 0) {
            out.println(("%d runs: %.0f%% converged within 10 scans, %.0f%% at all; from there on rmse %s m, of the"
                            + " worst run %s m, 95%% below %s m, heading %s°; falsely sure at %.2f%% of scans; %.2f ms"
                            + " per scan")
                    .formatted(
                            summary.seeds(),
                            100 * summary.converged10(),
                            100 * summary.converged(),
                            meters(summary.rmse()),
                            meters(summary.worstRmse()),
                            meters(summary.p95()),
                            summary.headingRmse() == null
                                    ? "-"
                                    : "%.2f".formatted(Math.toDegrees(summary.headingRmse())),
                            100 * summary.falselySure(),
                            summary.msPerScan()));
        }
        out.flush();
    }

    private static String meters(@Nullable Double value) {
        return value == null ? "-" : "%.3f".formatted(value);
    }
}
