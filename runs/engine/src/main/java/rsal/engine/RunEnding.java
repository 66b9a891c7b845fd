package rsal.engine;

import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.scenario.RunPlan;

/// How a run ends: a success in which an agent failed is a failure, unless the scenario tolerates that.
///
/// @param outcome its word
/// @param words for the log of events
record RunEnding(String outcome, String words) {
    static final String STOPPED = "stopped"; // by somebody

    /// @param how the scenario or somebody else ends it
    /// @param judges whether agents that failed count
    static RunEnding of(String how, RunPlan plan, RunAssembly assembly, boolean judges) {
        Set<String> failed = !judges || plan.toleratesFailedAgents()
                ? Set.of()
                : Stream.of(
                                assembly.failedAgents().keySet(),
                                assembly.unhandledGoals().keySet())
                        .flatMap(Set::stream)
                        .collect(Collectors.toCollection(TreeSet::new));
        boolean fails = !failed.isEmpty() && !how.equals(RunPlan.Outcome.TIMEOUT.word());
        String outcome = fails ? RunPlan.Outcome.FAILURE.word() : how;
        return new RunEnding(
                outcome, "ends: " + outcome + (failed.isEmpty() ? "" : "; failed: " + String.join(", ", failed)));
    }

    /// One of which nothing is to be judged, as before its agents are there.
    static RunEnding of(String how) {
        return new RunEnding(how, "ends: " + how);
    }
}
