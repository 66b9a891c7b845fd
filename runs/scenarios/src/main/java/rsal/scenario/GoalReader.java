package rsal.scenario;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import rsal.metric.QuantityType;
import rsal.scenario.RobotReader.Role;
import rsal.scenario.RunPlan.Better;
import rsal.scenario.RunPlan.MetricDefinition;
import rsal.scenario.RunPlan.Outcome;
import rsal.scenario.RunPlan.Stop;
import rsal.scenario.condition.Condition;
import rsal.scenario.condition.Grammar;
import rsal.scenario.condition.Grammar.Names;
import rsal.scenario.condition.InvalidExpression;
import rsal.scenario.condition.MetricExpression;
import rsal.scenario.condition.MetricWords;
import rsal.scenario.condition.Quantity;
import rsal.scenario.condition.RunQuantities;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;

/// Reads when a run ends and what is measured.
final class GoalReader {
    private static final Pattern BETWEEN_NAMES = Pattern.compile("[^\\w-]+");

    /// What is measured of a world that nobody wrote a scenario for.
    static final List<MetricDefinition> OF_WORLDS = List.of(
            measured("distance", "m", new MetricExpression.Distance(Optional.empty()), true),
            measured("collisions", "", count(RunQuantities.COLLISIONS), false),
            measured("wallCollisions", "", count(RunQuantities.WALL_COLLISIONS), false));

    private final RobotNames robots;
    private final List<String> depots;
    private final List<String> reaches;
    private final List<String> places;
    private final MetricWords words;
    private final Problems problems;

    GoalReader(
            RobotNames robots, List<PlannedThings> things, List<Place> places, MetricWords words, Problems problems) {
        this.robots = robots;
        this.depots = names(things, group -> group.depot().isPresent());
        this.reaches = names(things, group -> group.reach().isPresent());
        this.places = places.stream().map(Place::name).toList();
        this.words = words;
        this.problems = problems;
    }

    private static MetricDefinition measured(String name, String unit, MetricExpression from, boolean perRobot) {
        return new MetricDefinition(
                name, unit, from, perRobot, Better.NEITHER, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    private static MetricExpression count(QuantityType type) {
        return new MetricExpression.Count(Quantity.of(type));
    }

    private static List<String> names(List<PlannedThings> things, Predicate<PlannedThings> which) {
        return things.stream().filter(which).map(PlannedThings::name).toList();
    }

    List<Stop> stops(Section run) {
        var stops = new ArrayList<Stop>();
        for (Section stop : Format.groups(run, "stop")) {
            Optional<Condition> when = expression(stop, "when", Grammar::condition);
            var word = stop.value(Format.OUTCOME).orElse("");
            var outcome = Format.of(Outcome.values(), Outcome::word, word);
            var after = Duration.ofMillis(
                    Math.round(1000 * (Double) stop.value(Format.AFTER).orElse(0.0)));
            when.ifPresent(condition -> stops.add(new Stop(condition, outcome, after)));
            stop.done();
        }
        return stops;
    }

    List<MetricDefinition> metrics(Section root) {
        var metrics = new ArrayList<MetricDefinition>();
        for (Section metric : Format.groups(root, "metrics")) {
            if (metric.has("type") && !metric.has("name")) {
                metric.problem("type", "A metric has no 'type'.", "Types of metrics are listed in 'metricTypes'.");
                continue;
            }
            String name = metric.text("name");
            if (!name.isEmpty() && !Format.NAME.matcher(name).matches()) {
                metric.problem("name", "'%s' can't be the name of a metric.".formatted(name), "");
            }
            if (metrics.stream().anyMatch(other -> other.name().equals(name))) {
                metric.problem("name", "There are two metrics '%s'.".formatted(name), "Rename one of them.");
            }
            String unit = metric.text("unit", "");
            Optional<MetricExpression> from = expression(metric, "from", Grammar::metric);
            boolean perRobot = "robot".equals(metric.value(Format.PER).orElse(""));
            if (perRobot && from.isPresent() && !from.get().canBePerRobot()) {
                metric.problem("per", "A metric of the whole run has no value per robot.", "Remove 'per'.");
            }
            Better better = Format.of(
                    Better.values(), Better::word, metric.value(Format.BETTER).orElse(""));
            Section bound = metric.section("bound");
            double min = bound.number("min", Double.NEGATIVE_INFINITY);
            double max = bound.number("max", Double.POSITIVE_INFINITY);
            bound.done();
            metric.done();
            from.ifPresent(f -> metrics.add(new MetricDefinition(name, unit, f, perRobot, better, min, max)));
        }
        return metrics;
    }

    /// That an expression may name; any that it does when nobody knows which there are.
    private Names names(String expression) {
        List<String> roles = robots.open()
                ? List.of(BETWEEN_NAMES.split(expression))
                : robots.roles().stream().map(Role::name).toList();
        return new Names(roles, depots, reaches, places, words);
    }

    private <T> Optional<T> expression(Section section, String key, BiFunction<String, Names, T> parse) {
        String text = section.text(key);
        if (text.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Optional.of(parse.apply(text, names(text)));
        } catch (InvalidExpression e) {
            Location at = section.locationOf(key);
            problems.add(
                    new Location(at.file(), at.line(), at.column() + e.position()),
                    "'%s' in '%s', character %d: %s"
                            .formatted(
                                    section.path(key),
                                    text.length() <= 80 ? text : text.substring(0, 77) + "...",
                                    e.position() + 1,
                                    e.getMessage()),
                    e.remedy());
            return Optional.empty();
        }
    }
}
