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
/// [#HELD], or all the while when there are not so many, and sure of it before it was wrong again, since who is near
/// by chance knows nothing; empty when it never was
/// @param errors of positions from there on, ascending [m]; none when it never was right
/// @param headingRmse the same [rad]; NaN when it never was right
/// @param near share from there on within [#NEAR] and [#NEARLY]
/// @param falselySure scans, of all, for which it said to be localized and was not near
public record Verdict(
        int judged, OptionalInt converged, List<Double> errors, double headingRmse, double near, int falselySure) {
    /// How far off is still near [m].
    public static final double NEAR = 0.5;

    /// The same of the heading: 15° [rad].
    public static final double NEARLY = Math.toRadians(15);

    /// How many scans in a row must be near for it to have converged.
    public static final int HELD = 5;

    /// How right runs were from where each was right first, those that never were left out.
    ///
    /// @param rmse of the positions of all their scans [m]; NaN, as the others, when none ever was right
    /// @param worstRmse of the run that has the largest [m]
    /// @param p95 what 95 % of the errors of all their scans are below [m]
    /// @param headingRmse of all their scans [rad]
    public record Pooled(double rmse, double worstRmse, double p95, double headingRmse) {}

    public Verdict {
        errors = List.copyOf(errors);
    }

    /// Of positions from where it was right on [m]; NaN when it never was.
    public double rmse() {
        return rootMeanSquare(errors);
    }

    /// The same, what 95 % of the errors are below [m].
    public double p95() {
        return percentile(errors, 0.95);
    }

    /// The same, the largest error [m].
    public double worst() {
        return percentile(errors, 1);
    }

    /// Sums runs up: each counts as much as it has scans since it was right.
    public static Pooled pooled(List<Verdict> runs) {
        List<Verdict> right =
                runs.stream().filter(run -> run.converged().isPresent()).toList();
        List<Double> errors =
                right.stream().flatMap(run -> run.errors().stream()).sorted().toList();
        double headingSquares = right.stream()
                .mapToDouble(run -> run.errors().size() * run.headingRmse() * run.headingRmse())
                .sum();
        return new Pooled(
                rootMeanSquare(errors),
                right.stream().mapToDouble(Verdict::rmse).max().orElse(Double.NaN),
                percentile(errors, 0.95),
                errors.isEmpty() ? Double.NaN : Math.sqrt(headingSquares / errors.size()));
    }

    /// Judges steps that [Replay] made.
    public static Verdict of(List<Replay.Step> all) {
        List<Replay.Step> steps =
                all.stream().filter(step -> step.error().isPresent()).toList();
        int falselySure = (int)
                steps.stream().filter(step -> isSure(step) && !isNear(step)).count();
        int right = 0; // in a row
        boolean sure = false; // at one of them
        for (int i = 0; i < steps.size(); i++) {
            boolean near = isNear(steps.get(i));
            right = near ? right + 1 : 0;
            sure = near && (sure || isSure(steps.get(i)));
            if (sure && right >= Math.min(HELD, steps.size())) {
                return from(steps, i - right + 1, falselySure);
            }
        }
        return new Verdict(steps.size(), OptionalInt.empty(), List.of(), Double.NaN, 0, falselySure);
    }

    private static Verdict from(List<Replay.Step> steps, int first, int falselySure) {
        List<Replay.Step> after = steps.subList(first, steps.size());
        return new Verdict(
                steps.size(),
                OptionalInt.of(first + 1),
                after.stream().map(step -> step.error().orElseThrow()).sorted().toList(),
                rootMeanSquare(after.stream()
                        .map(step -> step.headingError().orElseThrow())
                        .toList()),
                (double) after.stream().filter(Verdict::isNear).count() / after.size(),
                falselySure);
    }

    private static boolean isSure(Replay.Step step) {
        return step.estimate().quality() == Quality.LOCALIZED;
    }

    private static boolean isNear(Replay.Step step) {
        return step.error().orElseThrow() <= NEAR && step.headingError().orElseThrow() <= NEARLY;
    }

    private static double rootMeanSquare(List<Double> values) {
        return Math.sqrt(values.stream().mapToDouble(v -> v * v).average().orElse(Double.NaN));
    }

    /// @param sorted ascending
    private static double percentile(List<Double> sorted, double share) {
        int rank = (int) Math.ceil(share * sorted.size());
        return sorted.isEmpty() ? Double.NaN : sorted.get(Math.clamp(rank - 1, 0, sorted.size() - 1));
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
