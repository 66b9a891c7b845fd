package rsal.bench.measurement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/// What one way of doing something saves beside another, both tried under the same circumstances again and again (with
/// the same seeds): what differs between these is often more than what differs between the ways, and does not matter.
///
/// Names are `<name>`, the mean difference, and `<name>.share`, the same by the other's mean; each with `.low` and
/// `.high`, ends of its 95 % confidence interval. That of the share is the one of a ratio of means that are estimated
/// from pairs, for large samples: W. Cochran, Sampling Techniques, 3rd edition, equation 6.13.
public final class Saving {
    private Saving() {}

    public static List<String> names(String name) {
        var names = new ArrayList<>(Confidence.names(name));
        names.addAll(Confidence.names(share(name)));
        return names;
    }

    private static String share(String name) {
        return name + ".share";
    }

    /// @param ours what it cost in each trial
    /// @param theirs what the other way cost in the same
    public static List<Result> of(String name, String unit, double[] ours, double[] theirs) {
        double other = Arrays.stream(theirs).average().orElseThrow();
        double ratio = Arrays.stream(ours).average().orElseThrow() / other;
        double[] residuals = IntStream.range(0, ours.length)
                .mapToDouble(i -> ours[i] - ratio * theirs[i])
                .toArray();
        double[] saved = IntStream.range(0, ours.length)
                .mapToDouble(i -> theirs[i] - ours[i])
                .toArray();
        var results = new ArrayList<>(Confidence.more(name, unit, saved));
        results.addAll(
                Confidence.interval(Result.more(share(name), "", 1 - ratio), Confidence.margin(residuals) / other));
        return results;
    }
}
