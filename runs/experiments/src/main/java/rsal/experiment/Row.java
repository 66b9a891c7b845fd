package rsal.experiment;

import static java.util.Objects.requireNonNull;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import rsal.engine.report.RunResult;
import rsal.scenario.text.Folders;

/// The result of one run of an experiment. Part of what users build on: names and order stay, more may follow.
///
/// @param run its number, from 1, in the order of the design
/// @param combination its number, from 1
/// @param arguments all of the scenario's, as they were: Double, Long, String or Boolean
/// @param outcome as [RunResult] has it, or [#BROKEN]
/// @param reason why it broke, for people; empty when it did not
/// @param simulatedSeconds empty when it broke
/// @param wallSeconds how long it took; empty when it broke
/// @param eventHash equal for equal runs; empty when it broke
/// @param metrics by name; empty where there was nothing to measure
/// @param outOfBounds names of the metrics that are not within the bounds the scenario gives
/// @param failedAgents what went wrong with agents that ended by an error of their own, by name
public record Row(
        int run,
        int combination,
        String configuration,
        Map<String, Object> arguments,
        long seed,
        String outcome,
        String reason,
        OptionalDouble simulatedSeconds,
        OptionalDouble wallSeconds,
        String eventHash,
        Map<String, OptionalDouble> metrics,
        List<String> outOfBounds,
        Map<String, String> failedAgents) {
    /// The outcome of a run that could not go on, or not begin.
    public static final String BROKEN = "broken";

    public Row {
        requireNonNull(configuration);
        arguments = Collections.unmodifiableMap(new LinkedHashMap<>(arguments));
        requireNonNull(outcome);
        reason = Folders.without(reason);
        metrics = Collections.unmodifiableMap(new LinkedHashMap<>(metrics));
        outOfBounds = List.copyOf(outOfBounds);
        failedAgents = Collections.unmodifiableMap(new LinkedHashMap<>(failedAgents));
    }

    static Row of(Trial trial, Map<String, Object> arguments, RunResult result) {
        return new Row(
                trial.number(),
                trial.combination().number(),
                trial.combination().configuration(),
                arguments,
                trial.seed(),
                result.outcome(),
                "",
                OptionalDouble.of(result.simulatedSeconds()),
                OptionalDouble.of(result.wallSeconds()),
                result.eventHash(),
                result.metrics(),
                result.outOfBounds(),
                failed(result));
    }

    /// An agent without a plan for a goal has made an error, too.
    private static Map<String, String> failed(RunResult result) {
        var failed = new LinkedHashMap<String, String>();
        result.unhandledGoals()
                .forEach((agent, goals) -> failed.put(agent, "no plan for goal " + String.join(", ", goals)));
        result.failed().forEach((agent, why) -> failed.put(agent, Folders.without(why)));
        return failed;
    }

    static Row broken(Trial trial, Map<String, Object> arguments, String reason) {
        return new Row(
                trial.number(),
                trial.combination().number(),
                trial.combination().configuration(),
                arguments,
                trial.seed(),
                BROKEN,
                reason,
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                "",
                Map.of(),
                List.of(),
                Map.of());
    }

    public boolean isBroken() {
        return outcome.equals(BROKEN);
    }

    public boolean hasFailedAgents() {
        return !failedAgents.isEmpty();
    }

    /// Whether it is a failure, and agents failed; those that a scenario tolerates leave it what its conditions say.
    public boolean failedByAgents() {
        return hasFailedAgents() && outcome.equals("failure");
    }
}
