package rsal.agent.team;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/// Jobs that are called for, or that are given to one.
///
/// @param inRoutes whether a bid should also tell what each costs after each other
/// @param anew whether a bid should be as if the member had no job
/// @param auction by which the members divide the jobs; empty where the caller does
record Offer(List<Job> jobs, boolean inRoutes, boolean anew, Optional<AuctionTerms> auction) {
    Offer {
        jobs = List.copyOf(jobs);
    }

    Offer(List<Job> jobs, boolean inRoutes, boolean anew) {
        this(jobs, inRoutes, anew, Optional.empty());
    }

    @Override
    public String toString() {
        return jobs.stream().map(Job::name).collect(Collectors.joining(", "));
    }
}
