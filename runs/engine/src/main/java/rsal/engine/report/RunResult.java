package rsal.engine.report;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import rsal.data.Pose2d;

/// How a run ended, and its results.
///
/// @param outcome `success`, `failure` or `timeout`, as the scenario says; `limit` when the time was up that
///         its starter gave it; `stopped` by an operator. What would be a success, or at a limit, is a failure
///         when an agent failed or had no plan for a goal, unless the scenario tolerates that
/// @param eventHash SHA-256 in hexadecimal over all that happened; equal for equal runs
/// @param metrics by name, in the scenario's order; empty where there was nothing to measure
/// @param outOfBounds names of the metrics that are not within the bounds the scenario gives
/// @param endPoses where robots were at the end, in the frame `map`, by name: in truth where it is known, else
///         as they believed; without those of which nobody knows
/// @param failed agents that ended by an error of their own, each with what went wrong, by name
/// @param unhandledGoals goals for which agents had no plan at all, by name of the agent; the first ten of each
/// @param topics how much was said about each topic
/// @param communication who heard what, by sender, listener and topic; empty where the scenario does not limit
///         it
public record RunResult(
        String scenario,
        String configuration,
        long seed,
        String outcome,
        double simulatedSeconds,
        double wallSeconds,
        String eventHash,
        Map<String, OptionalDouble> metrics,
        List<String> outOfBounds,
        Map<String, Pose2d> endPoses,
        Map<String, String> failed,
        Map<String, List<String>> unhandledGoals,
        List<TopicTraffic> topics,
        List<Reception> communication) {
    public RunResult {
        metrics = Collections.unmodifiableMap(new LinkedHashMap<>(metrics));
        outOfBounds = List.copyOf(outOfBounds);
        endPoses = Collections.unmodifiableMap(new LinkedHashMap<>(endPoses));
        failed = Collections.unmodifiableMap(new TreeMap<>(failed));
        unhandledGoals = Collections.unmodifiableMap(new TreeMap<>(unhandledGoals));
        topics = List.copyOf(topics);
        communication = List.copyOf(communication);
    }
}
