package rsal.agent.team;

import java.util.List;
import java.util.stream.Collectors;

/// Jobs that are called for, or that are given to one.
///
/// @param inRoutes whether a bid should also tell what each costs after each other
/// @param anew whether a bid should be as if the member had no job
record Offer(List<Job> jobs, boolean inRoutes, boolean anew) {
    Offer {
        jobs = List.copyOf(jobs);
    }

    @Override
    public String toString() {
        return jobs.stream().map(Job::name).collect(Collectors.joining(", "));
    }
}
