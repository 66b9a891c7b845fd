package rsal.cli.log;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.navigation.replay.Replay;
import rsal.navigation.replay.Verdict;

/// What `rsal localize` found, as it is printed as JSON.
///
/// @param omitted scans left out since nothing tells where the wheels had brought the robot
/// @param skipped messages of the log that were not used, by reason
record LocalizeResult(
        String log,
        String map,
        int scans,
        int omitted,
        Map<String, Integer> skipped,
        Summary summary,
        List<RunView> runs) {
    /// @param time of the scan [s]
    /// @param x in the map frame [m]
    /// @param heading [rad]
    /// @param covariance rows of the 3 × 3 covariance of x, y and heading, the upper triangle [m, rad]
    /// @param error of the position [m]; null when it is not known where the robot was
    /// @param headingError [rad]; null when that is not known
    record StepView(
            double time,
            int line,
            double x,
            double y,
            double heading,
            double[] covariance,
            double confidence,
            String quality,
            int particles,
            double ms,
            @Nullable Double error,
            @Nullable Double headingError) {
        static StepView of(Replay.Step step) {
            PoseEstimate estimate = step.estimate();
            Pose2d pose = estimate.mapFromBase();
            Covariance2d c = estimate.covariance();
            var time = step.stop().time();
            return new StepView(
                    time.getEpochSecond() + time.getNano() * 1e-9,
                    step.stop().line(),
                    pose.x(),
                    pose.y(),
                    pose.theta(),
                    new double[] {c.xx(), c.xy(), c.xTheta(), c.yy(), c.yTheta(), c.thetaTheta()},
                    estimate.confidence(),
                    word(estimate.quality()),
                    step.particles(),
                    step.nanos() * 1e-6,
                    step.error().orElse(null),
                    step.headingError().orElse(null));
        }

        static String word(Quality quality) {
            return quality.name().toLowerCase(Locale.ROOT);
        }
    }

    /// @param localized share of the scans at which that was the quality
    /// @param ambiguous share of the scans at which that was the quality
    /// @param lost share of the scans at which that was the quality
    /// @param convergedAfter scans, from 1; null when it never did
    /// @param rmse and the like from there on [m]; null when it never converged
    record RunView(
            int seed,
            double localized,
            double ambiguous,
            double lost,
            int judged,
            @Nullable Integer convergedAfter,
            @Nullable Double rmse,
            @Nullable Double p95,
            @Nullable Double worst,
            @Nullable Double headingRmse,
            double near,
            int falselySure,
            double msPerScan,
            double msWorst,
            List<StepView> steps) {
        static RunView of(int seed, List<Replay.Step> steps, Verdict verdict) {
            OptionalInt converged = verdict.converged();
            return new RunView(
                    seed,
                    share(steps, Quality.LOCALIZED),
                    share(steps, Quality.AMBIGUOUS),
                    share(steps, Quality.LOST),
                    verdict.judged(),
                    converged.isPresent() ? converged.getAsInt() : null,
                    known(verdict.rmse()),
                    known(verdict.p95()),
                    known(verdict.worst()),
                    known(verdict.headingRmse()),
                    verdict.near(),
                    verdict.falselySure(),
                    steps.stream().mapToLong(Replay.Step::nanos).average().orElse(0) * 1e-6,
                    steps.stream().mapToLong(Replay.Step::nanos).max().orElse(0) * 1e-6,
                    steps.stream().map(StepView::of).toList());
        }

        private static double share(List<Replay.Step> steps, Quality word) {
            return Summary.share(
                    steps.stream()
                            .filter(step -> step.estimate().quality() == word)
                            .count(),
                    steps.size());
        }
    }

    /// @param judged scans of all runs of which it is known where they were taken
    /// @param converged10 share of the runs that converged within 10 scans
    /// @param rmse and the like are of all scans from where each run converged on; null when none did
    /// @param worstRmse of the run that has the largest; null when none converged
    /// @param falselySure share of the judged scans at which it said to be localized and was not near
    record Summary(
            int seeds,
            int judged,
            double converged,
            double converged10,
            @Nullable Double rmse,
            @Nullable Double worstRmse,
            @Nullable Double p95,
            @Nullable Double headingRmse,
            double near,
            double falselySure,
            double msPerScan) {
        static Summary of(List<RunView> runs, Verdict.Pooled pooled) {
            int judged = runs.stream().mapToInt(RunView::judged).sum();
            return new Summary(
                    runs.size(),
                    judged,
                    share(runs.stream().filter(r -> r.convergedAfter != null).count(), runs.size()),
                    share(
                            runs.stream()
                                    .filter(r -> r.convergedAfter != null && r.convergedAfter <= 10)
                                    .count(),
                            runs.size()),
                    known(pooled.rmse()),
                    known(pooled.worstRmse()),
                    known(pooled.p95()),
                    known(pooled.headingRmse()),
                    runs.stream().mapToDouble(RunView::near).average().orElse(0),
                    share(runs.stream().mapToInt(RunView::falselySure).sum(), judged),
                    runs.stream().mapToDouble(RunView::msPerScan).average().orElse(0));
        }

        private static double share(long part, int all) {
            return all == 0 ? 0 : (double) part / all;
        }
    }

    private static @Nullable Double known(double value) {
        return Double.isNaN(value) ? null : value;
    }
}
