package rsal.cli.terminal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import rsal.data.Pose2d;
import rsal.engine.report.Reception;
import rsal.engine.report.RunResult;
import rsal.scenario.RunPlan;
import rsal.scenario.text.Counted;
import rsal.scenario.text.NumberText;

/// A run's result for people.
record ResultText(RunPlan plan, RunResult result) {
    @Override
    public String toString() {
        var table = new TextTable("  ");
        String set = set();
        if (!set.isEmpty()) {
            table.row("set", set);
        }
        table.row("outcome", outcome())
                .row(
                        "time",
                        String.format(
                                Locale.ROOT,
                                plan.clock() == RunPlan.Clock.SIMULATED
                                        ? "%.1f s simulated in %.1f s"
                                        : "%.1f s, with start and end %.1f s",
                                result.simulatedSeconds(),
                                result.wallSeconds()));
        result.failed().forEach((agent, why) -> table.row(agent, "failed: " + why));
        result.unhandledGoals()
                .forEach((agent, goals) -> table.row(agent, "has no plan for: " + String.join(", ", goals)));
        result.metrics().forEach((name, value) -> table.row(name, measured(name, value)));
        if (plan.scenario().isWorld()) {
            result.endPoses().forEach((robot, pose) -> table.row("endPose." + robot, written(pose)));
        }
        if (!result.communication().isEmpty()) {
            table.row("communication", heard(result.communication()));
        }
        table.row("event hash", result.eventHash());
        String joined = plan.with().map(" with %s"::formatted).orElse("");
        return "%s:%s%s, seed %d\n".formatted(result.scenario(), result.configuration(), joined, result.seed()) + table;
    }

    /// `limit` is no outcome of the scenario's.
    private String outcome() {
        return result.outcome().equals("limit") ? "limit (ended by --for)" : result.outcome();
    }

    private static String written(Pose2d pose) {
        return String.format(
                Locale.ROOT, "x %.2f m, y %.2f m, %.0f°", pose.x(), pose.y(), Math.toDegrees(pose.theta()));
    }

    /// What was set by those that started the run: `guards=3, places=0 -1`.
    private String set() {
        return plan.options().arguments().keySet().stream()
                .map(name -> name + "=" + plan.arguments().get(name))
                .collect(Collectors.joining(", "));
    }

    private static String heard(List<Reception> all) {
        return "%s heard, %d lost"
                .formatted(
                        Counted.of(all.stream().mapToLong(Reception::heard).sum(), "message"),
                        all.stream().mapToLong(Reception::lost).sum());
    }

    private String measured(String name, OptionalDouble value) {
        if (value.isEmpty()) {
            return "–";
        }
        String unit = metric(name).map(RunPlan.MetricDefinition::unit).orElse("");
        String bounds = result.outOfBounds().contains(name) ? "   out of bounds" : "";
        return (NumberText.of(value.getAsDouble()) + " " + unit).strip() + bounds;
    }

    /// What a value is of: a robot's value is called `<name>.<robot>`.
    private Optional<RunPlan.MetricDefinition> metric(String name) {
        return plan.metrics().stream()
                .filter(m -> name.equals(m.name()) || (m.perRobot() && name.startsWith(m.name() + ".")))
                .findFirst();
    }
}
