package rsal.navigation.replay;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import rsal.data.PoseEstimate.Quality;

/// How right a localizer was along a course.
///
/// @param judged scans of which it is known where they were taken; the rest of this is about them
/// @param converged after how many of them it was right, from 1: within [#NEAR] and [#NEARLY] from there on for
/// [#HELD], or to the end; empty when it never was
/// @param rmse of positions from there on [m]; NaN when it never was right
/// @param p95 likewise, what 95 % of the errors are below [m]
/// @param worst likewise, the largest error [m]
/// @param headingRmse likewise [rad]
/// @param near share from there on within [#NEAR] and [#NEARLY]
/// @param falselySure scans, of all, for which it said to be localized and was not near
public record Verdict(
        int judged,
        OptionalInt converged,
        double rmse,
        double p95,
        double worst,
        double headingRmse,
        double near,
        int falselySure) {
    /// How far off is still near [m].
    public static final double NEAR = 0.5;

    /// Likewise of the heading: 15° [rad].
    public static final double NEARLY = Math.toRadians(15);

    /// How many scans in a row must be near for it to have converged.
    public static final int HELD = 5;

    /// Judges steps that [Replay] made.
    public static Verdict of(List<Replay.Step> all) {
        List<Replay.Step> steps =
                all.stream().filter(step -> step.error().isPresent()).toList();
        int falselySure = (int) steps.stream()
                .filter(step -> step.estimate().quality() == Quality.LOCALIZED && !isNear(step))
                .count();
        int right = 0; // in a row
        for (int i = 0; i < steps.size(); i++) {
            right = isNear(steps.get(i)) ? right + 1 : 0;
            if (right == HELD || (right > 0 && i == steps.size() - 1)) {
                return from(steps, i - right + 1, falselySure);
            }
        }
        return new Verdict(
                steps.size(), OptionalInt.empty(), Double.NaN, Double.NaN, Double.NaN, Double.NaN, 0, falselySure);
    }

    private static Verdict from(List<Replay.Step> steps, int first, int falselySure) {
        List<Replay.Step> after = steps.subList(first, steps.size());
        double[] errors = after.stream()
                .mapToDouble(step -> step.error().orElseThrow())
                .sorted()
                .toArray();
        double[] headings = after.stream()
                .mapToDouble(step -> step.headingError().orElseThrow())
                .toArray();
        return new Verdict(
                steps.size(),
                OptionalInt.of(first + 1),
                rootMeanSquare(errors),
                percentile(errors, 0.95),
                errors[errors.length - 1],
                rootMeanSquare(headings),
                (double) after.stream().filter(Verdict::isNear).count() / after.size(),
                falselySure);
    }

    private static boolean isNear(Replay.Step step) {
        return step.error().orElseThrow() <= NEAR && step.headingError().orElseThrow() <= NEARLY;
    }

    static double rootMeanSquare(double[] values) {
        return Math.sqrt(Arrays.stream(values).map(v -> v * v).average().orElse(Double.NaN));
    }

    /// @param sorted ascending, not empty
    static double percentile(double[] sorted, double share) {
        int rank = (int) Math.ceil(share * sorted.length);
        return sorted[Math.clamp(rank - 1, 0, sorted.length - 1)];
    }

    /// The median of what is there; NaN when nothing is.
    public static double median(double[] values) {
        double[] sorted =
                Arrays.stream(values).filter(v -> !Double.isNaN(v)).sorted().toArray();
        return sorted.length == 0
                ? Double.NaN
                : IntStream.of((sorted.length - 1) / 2, sorted.length / 2)
                        .mapToDouble(i -> sorted[i])
                        .average()
                        .orElseThrow();
    }
}
