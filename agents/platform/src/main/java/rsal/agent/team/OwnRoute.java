package rsal.agent.team;

import java.util.ArrayList;
import java.util.List;

/// The route of one member in an auction: finds the best position for one more job.
final class OwnRoute {
    private final Estimate estimate;
    private final BidRule rule;
    private final double discount;
    private final List<Integer> jobs = new ArrayList<>();

    /// @param discount what is left of a job's value after a meter
    OwnRoute(Estimate estimate, BidRule rule, double discount) {
        this.estimate = estimate;
        this.rule = rule;
        this.discount = discount;
    }

    /// A job at its best position.
    ///
    /// @param bid +∞ where the member can't do it
    record Insertion(int job, int position, double bid) {}

    Insertion best(Integer job) {
        double before = rule.value(estimate, jobs, discount);
        int position = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i <= jobs.size(); i++) {
            jobs.add(i, job);
            double cost = rule.value(estimate, jobs, discount);
            jobs.remove(/* index */ i);
            if (cost < least) {
                least = cost;
                position = i;
            }
        }
        boolean possible = least < Double.POSITIVE_INFINITY;
        return new Insertion(job, position, possible ? rule.of(least, before) : Double.POSITIVE_INFINITY);
    }

    void insert(Insertion insertion) {
        jobs.add(insertion.position, insertion.job);
    }

    void remove(Integer job) {
        jobs.remove(/* element */ job);
    }

    List<Integer> jobs() {
        return List.copyOf(jobs);
    }
}
