package rsal.recording;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import rsal.data.Pose2d;
import rsal.engine.report.RunResult;
import rsal.mcap.McapWriter;
import rsal.mcap.Metadata;
import rsal.scenario.RunPlan;

/// How a recorded run ended, as metadata of its file.
final class RecordedOutcome {
    static final String NAME = "rsal.result";
    static final String METRIC = "metric.";
    private static final String FAILED = "failed."; // and an agent's name
    private static final String END_POSE = "endPose."; // and a robot's name: x y theta
    private static final String UNHANDLED = "unhandledGoals.";

    private RecordedOutcome() {}

    /// As it was written.
    ///
    /// @param entries as [#write] has them
    /// @return empty when there is none
    static Optional<RunResult> read(Map<String, String> entries, RunPlan plan) {
        if (!entries.containsKey("outcome")) {
            return Optional.empty();
        }
        var metrics = new LinkedHashMap<String, OptionalDouble>();
        var poses = new LinkedHashMap<String, Pose2d>();
        var failed = new LinkedHashMap<String, String>();
        var unhandled = new LinkedHashMap<String, List<String>>();
        entries.forEach((name, value) -> {
            if (name.startsWith(FAILED)) {
                failed.put(name.substring(FAILED.length()), value);
            }
            if (name.startsWith(END_POSE)) {
                pose(value).ifPresent(pose -> poses.put(name.substring(END_POSE.length()), pose));
            }
            if (name.startsWith(UNHANDLED)) {
                unhandled.put(name.substring(UNHANDLED.length()), List.of(value.split("\n")));
            }
            if (name.startsWith(METRIC)) {
                double number = number(value);
                metrics.put(
                        name.substring(METRIC.length()),
                        Double.isNaN(number) ? OptionalDouble.empty() : OptionalDouble.of(number));
            }
        });
        return Optional.of(new RunResult(
                plan.scenario().name(),
                plan.configuration(),
                plan.seed(),
                entries.getOrDefault("outcome", ""),
                number(entries.getOrDefault("simulatedSeconds", "")),
                number(entries.getOrDefault("wallSeconds", "")),
                entries.getOrDefault("eventHash", ""),
                metrics,
                Stream.of(entries.getOrDefault("outOfBounds", "").split(" ", -1))
                        .filter(name -> !name.isEmpty())
                        .toList(),
                poses,
                failed,
                unhandled,
                List.of(),
                List.of()));
    }

    private static Optional<Pose2d> pose(String text) {
        double[] numbers = Stream.of(text.split(" ", -1))
                .mapToDouble(RecordedOutcome::number)
                .toArray();
        return numbers.length == 3
                ? Optional.of(new Pose2d(numbers[0], numbers[1], numbers[2])).filter(Pose2d::isFinite)
                : Optional.empty();
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException _) {
            return Double.NaN;
        }
    }

    /// @param result empty when the run broke, or its recording ended before it did
    static void write(McapWriter file, Optional<RunResult> result, long droppedStates) throws IOException {
        file.metadata(new Metadata(NAME, entries(result, droppedStates)));
    }

    static Map<String, String> entries(Optional<RunResult> result, long droppedStates) {
        var entries = new LinkedHashMap<String, String>();
        result.ifPresent(ended -> {
            entries.put("outcome", ended.outcome());
            entries.put("simulatedSeconds", Double.toString(ended.simulatedSeconds()));
            entries.put("wallSeconds", Double.toString(ended.wallSeconds()));
            entries.put("eventHash", ended.eventHash());
            ended.metrics()
                    .forEach((name, value) ->
                            entries.put(METRIC + name, value.isPresent() ? Double.toString(value.getAsDouble()) : ""));
            entries.put("outOfBounds", String.join(" ", ended.outOfBounds()));
            ended.endPoses()
                    .forEach((robot, pose) ->
                            entries.put(END_POSE + robot, "%s %s %s".formatted(pose.x(), pose.y(), pose.theta())));
            ended.failed().forEach((agent, why) -> entries.put(FAILED + agent, why));
            ended.unhandledGoals().forEach((agent, goals) -> entries.put(UNHANDLED + agent, String.join("\n", goals)));
        });
        entries.put("droppedStates", Long.toString(droppedStates));
        return entries;
    }
}
