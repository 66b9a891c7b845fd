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
import rsal.scenario.RunPlan.Measured;
import rsal.scenario.RunPlan.Outcome;
import rsal.scenario.RunPlan.Stop;
import rsal.scenario.condition.Condition;
import rsal.scenario.condition.Grammar;
import rsal.scenario.condition.Grammar.Names;
import rsal.scenario.condition.InvalidExpression;
import rsal.scenario.condition.Measure;
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
    static final List<Measured> OF_WORLDS = List.of(
            measured("distance", "m", new Measure.Distance(Optional.empty()), true),
            measured("collisions", "", count(RunQuantities.COLLISIONS), false),
            measured("wallCollisions", "", count(RunQuantities.WALL_COLLISIONS), false));

    private final RobotNames robots;
    private final List<String> depots;
    private final List<String> reaches;
    private final List<String> places;
    private final MetricWords metrics;
    private final Problems problems;

    GoalReader(
            RobotNames robots, List<PlannedThings> things, List<Place> places, MetricWords metrics, Problems problems) {
        this.robots = robots;
        this.depots = names(things, group -> group.depot().isPresent());
        this.reaches = names(things, group -> group.reach().isPresent());
        this.places = places.stream().map(Place::name).toList();
        this.metrics = metrics;
        this.problems = problems;
    }

    private static Measured measured(String name, String unit, Measure from, boolean perRobot) {
        return new Measured(
                name, unit, from, perRobot, Better.NEITHER, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    private static Measure count(QuantityType type) {
        return new Measure.Count(Quantity.of(type));
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

    List<Measured> measures(Section root) {
        var measures = new ArrayList<Measured>();
        for (Section measure : Format.groups(root, "measure")) {
            String name = measure.text("name");
            if (!name.isEmpty() && !Format.NAME.matcher(name).matches()) {
                measure.problem("name", "(%s) can't be the name of a measure.".formatted(name), "");
            }
            if (measures.stream().anyMatch(other -> other.name().equals(name))) {
                measure.problem("name", "There are two measures (%s).".formatted(name), "Rename one of them.");
            }
            String unit = measure.text("unit", "");
            Optional<Measure> from = expression(measure, "from", Grammar::measure);
            boolean perRobot = "robot".equals(measure.value(Format.PER).orElse(""));
            if (perRobot && from.isPresent() && !from.get().canBePerRobot()) {
                measure.problem("per", "A measure of the whole run has no value per robot.", "Leave (per) out.");
            }
            Better better = Format.of(
                    Better.values(), Better::word, measure.value(Format.BETTER).orElse(""));
            Section bound = measure.section("bound");
            double min = bound.number("min", Double.NEGATIVE_INFINITY);
            double max = bound.number("max", Double.POSITIVE_INFINITY);
            bound.done();
            measure.done();
            from.ifPresent(f -> measures.add(new Measured(name, unit, f, perRobot, better, min, max)));
        }
        return measures;
    }

    /// That an expression may name; any that it does when nobody knows which there are.
    private Names names(String expression) {
        List<String> roles = robots.open()
                ? List.of(BETWEEN_NAMES.split(expression))
                : robots.roles().stream().map(Role::name).toList();
        return new Names(roles, depots, reaches, places, metrics);
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
                    "(%s) in (%s), character %d: %s"
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
