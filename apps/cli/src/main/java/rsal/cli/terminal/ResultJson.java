package rsal.cli.terminal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.engine.report.Reception;
import rsal.engine.report.RunResult;
import rsal.engine.report.TopicTraffic;
import rsal.scenario.RunPlan;

/// A run's result for programs. Part of what users build on: names and order stay.
///
/// @param metrics null where there was nothing to measure
/// @param endPoses where robots were at the end in the frame `map` [m, m, rad], by name: in truth where it is
///         known
/// @param topics how many messages were said and heard about each, and lost by whichever cause
/// @param communication empty where the scenario does not limit it
/// @param failed what went wrong with agents that ended by an error of their own, by name
/// @param unhandledGoals goals for which agents had no plan at all, by name of the agent
/// @param arguments all of the scenario, by name
/// @param with the scenario that joined it; null when none did
record ResultJson(
        String scenario,
        String configuration,
        long seed,
        String outcome,
        double simulatedSeconds,
        double wallSeconds,
        String eventHash,
        Map<String, @Nullable Double> metrics,
        Map<String, EndPose> endPoses,
        List<Topic> topics,
        List<Reception> communication,
        Map<String, String> failed,
        Map<String, List<String>> unhandledGoals,
        Map<String, Object> arguments,
        Optional<String> with) {
    record Topic(String topic, long said, long heard, long lost) {}

    record EndPose(double x, double y, double theta) {}

    static ResultJson of(RunPlan plan, RunResult result) {
        var metrics = new LinkedHashMap<String, @Nullable Double>();
        result.metrics().forEach((name, value) -> metrics.put(name, value.isPresent() ? value.getAsDouble() : null));
        var endPoses = new LinkedHashMap<String, EndPose>();
        result.endPoses().forEach((robot, pose) -> endPoses.put(robot, new EndPose(pose.x(), pose.y(), pose.theta())));
        return new ResultJson(
                result.scenario(),
                result.configuration(),
                result.seed(),
                result.outcome(),
                result.simulatedSeconds(),
                result.wallSeconds(),
                result.eventHash(),
                metrics,
                endPoses,
                result.topics().stream().map(ResultJson::topic).toList(),
                result.communication(),
                result.failed(),
                result.unhandledGoals(),
                plan.arguments(),
                plan.with());
    }

    private static Topic topic(TopicTraffic all) {
        long lost = all.lost().values().stream().mapToLong(Long::longValue).sum();
        return new Topic(all.topic(), all.said(), all.heard(), lost);
    }
}
