package rsal.agent.team;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rsal.data.Point2d;

/// What jobs would cost a member: length of way [m], more where it is narrow, and what the work itself is worth in
/// these.
///
/// @param free whether it can begin now; else the costs begin with what it still has to do
/// @param first of each job, if it is the next; +∞ for what it can't do
/// @param after the cost of job j right after job i is `after.get(i).get(j)`; empty when nobody asked for it
public record Estimate(boolean free, List<Double> first, List<List<Double>> after) {
    public Estimate {
        first = List.copyOf(first);
        after = after.stream().map(List::copyOf).toList();
        boolean square = after.isEmpty() || after.size() == first.size();
        for (List<Double> row : after) {
            square &= row.size() == first.size();
        }
        if (!square || first.stream().anyMatch(cost -> cost.isNaN())) {
            throw new IllegalArgumentException("Costs of %d jobs after %d others, or none: %s, %s."
                    .formatted(first.size(), after.size(), first, after));
        }
    }

    /// Of one who is free and goes straight to jobs that are done where they are.
    public static Estimate straight(Point2d from, List<Point2d> places) {
        return new Estimate(
                true,
                costs(from, places),
                places.stream().map(place -> costs(place, places)).toList());
    }

    private static List<Double> costs(Point2d from, List<Point2d> places) {
        return places.stream().map(from::distanceTo).toList();
    }

    /// What only these jobs would cost.
    Estimate of(List<Integer> jobs) {
        return new Estimate(
                free,
                jobs.stream().map(first::get).toList(),
                jobs.stream()
                        .map(job -> jobs.stream().map(after.get(job)::get).toList())
                        .toList());
    }

    /// The same, where some jobs can't be done.
    Estimate without(Set<Integer> impossible) {
        return new Estimate(
                free,
                never(first, impossible),
                after.stream().map(row -> never(row, impossible)).toList());
    }

    private static List<Double> never(List<Double> costs, Set<Integer> impossible) {
        return IntStream.range(0, costs.size())
                .mapToObj(job -> impossible.contains(job) ? Double.POSITIVE_INFINITY : costs.get(job))
                .toList();
    }

    @Override
    public String toString() {
        return (free ? "" : "later, ")
                + first.stream()
                        .map(cost -> cost.isInfinite() ? "no" : String.format(Locale.ROOT, "%.1f", cost))
                        .collect(Collectors.joining(", "));
    }
}
