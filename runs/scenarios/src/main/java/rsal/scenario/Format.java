package rsal.scenario;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;
import rsal.scenario.fault.FaultKind;
import rsal.scenario.fault.Span;
import rsal.scene.Touch;
import rsal.settings.Parameter;
import rsal.settings.Section;
import rsal.settings.Value;

/// The settings of the format itself, declared once for the reader and the schema.
final class Format {
    static final int VERSION = 1;

    /// What robots, agents, arguments, configurations and metrics can be called.
    static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_-]{0,39}");

    static final int MAX_ROBOTS = 1000;
    static final int MAX_AGENTS = 2000;
    static final int MAX_ITEMS = 100;

    /// Values for arguments of a scenario.
    static final String ARGUMENTS = "arguments";
    /// Values for parameters of an agent, a device or a metric.
    static final String PARAMETERS = "parameters";

    static final String DEFAULT_CONFIGURATION = "default";
    static final String DEFAULT_MRS = "sim";
    static final String DEFAULT_MAS = "plain";

    /// How to get those that are not part of the default assembly, by key.
    static final Map<String, String> HOSTS_APART = Map.of(
            "jadex",
            "It is under GPL-3.0 and comes only when it is asked for. Maybe try RSAL_WITH=jadex ./rsal run hunt-and-prey"
                    + " --mas jadex --clock wall (docs/how-to/jadex.md).");

    static final Parameter<String> ON_COLLISION = Parameter.choice(
            "onCollision",
            Touch.STALL.word(),
            Touch.words(),
            "Whether robots that drive into something stop or slide along it; otherwise as the file of the world has it.");

    static final Parameter<String> ARGUMENT_TYPE = Parameter.choice(
                    "type",
                    "",
                    List.of("integer", "number", "string", "boolean"),
                    "What kind of value the argument takes.")
            .required();

    static final Parameter<Integer> COUNT =
            Parameter.integer("count", 1, 1, MAX_ROBOTS, "", "Number of them; their names are then role-1, role-2…");
    static final Parameter<Boolean> PROXY = Parameter.flag(
            "proxy",
            false,
            "Whether real robots have proxies in the simulated world, where simulated robots see them.");
    static final Parameter<Boolean> OVERLAY = Parameter.flag(
            "overlay", false, "Whether lasers and sonars of real robots see what is in the simulated world, too.");
    static final Parameter<Double> CLEARANCE = Parameter.number(
            "clearance", 0.4, 0, 100, "m", "Distance to all that is not free, and half of that to other robots.");
    static final Parameter<Double> PASSAGE = Parameter.number(
                    "passage",
                    0.3,
                    0,
                    100,
                    "m",
                    "How far from walls paths between free places stay; as 'clearance' without it.")
            .required();
    static final Parameter<Boolean> FREE = Parameter.flag("free", true, "Somewhere free, chosen by the seed.");
    static final Parameter<Boolean> OBSTACLE = Parameter.flag("obstacle", true, "Whether robots collide with them.");
    static final Parameter<Boolean> GRIPPABLE = Parameter.flag("grippable", false, "Whether grippers can hold them.");
    static final Parameter<Integer> FIDUCIAL = Parameter.integer(
            "fiducial",
            0,
            0,
            1_000_000,
            "",
            "Marker id of the first one; the ids of the others follow. 0: no markers.");
    static final Parameter<Double> GIVING_POWER = Parameter.number(
            "givingPower", 0, 0, 1e9, "W", "Power with which each charges robots that touch it or stand on it.");
    static final Parameter<Double> COMES_EVERY = Parameter.number(
            "every",
            0,
            0,
            1e6,
            "s",
            "Mean time between two of them, which are added at random times; 0: all are there at the start.");
    static final Parameter<Double> DEPOT_RADIUS =
            Parameter.number("radius", 1, 0.1, 100, "m", "How far from its middle a depot reaches.");
    static final Parameter<Double> PLACE_RADIUS =
            Parameter.number("radius", 1, 0.01, 1e6, "m", "How far from 'at' a place reaches.");
    static final Parameter<Double> WITHIN = Parameter.number(
            "within",
            1,
            0.1,
            100,
            "m",
            "Maximum distance from the robot's center to the thing's center, without a wall between " + "them.");
    static final Parameter<Double> DURATION =
            Parameter.number("duration", 0, 0, 3600, "s", "For how long a robot must be there without interruption.");

    /// Stands for all robots where a role could stand.
    static final String ALL = "all";

    static final Parameter<?> SEED = new Parameter<Long>(
            "seed",
            Parameter.Kind.INTEGER,
            Optional.of(1L),
            Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            List.of(),
            "",
            "All randomness of the run comes from it.");
    static final Parameter<String> FAILED_AGENTS = Parameter.choice(
            "failedAgents",
            "fail",
            List.of("fail", "tolerate"),
            "Outcome of a run in which an agent failed: a failure, or what its conditions say.");
    static final Parameter<String> MODE =
            Parameter.choice("mode", "simulated", List.of("simulated", "wall"), "Whether time is simulated or real.");
    static final Parameter<Double> SPEED =
            Parameter.number("speed", 1, 0.01, 1000, "", "Simulated over real time; max for as fast as it can.");
    static final Parameter<String> OUTCOME = Parameter.choice(
                    "outcome",
                    "",
                    words(RunPlan.Outcome.values(), RunPlan.Outcome::word),
                    "How the run ends when the condition holds.")
            .required();
    static final Parameter<Double> AFTER =
            Parameter.number("after", 0, 0, 3600, "s", "How long the run continues after its outcome is decided.");
    static final Parameter<String> BETTER = Parameter.choice(
            "better", "neither", words(RunPlan.Better.values(), RunPlan.Better::word), "Which values are better.");
    static final Parameter<String> PER = Parameter.choice(
            "per", "run", List.of("run", "robot"), "Whether the run has one value or each robot its own.");

    static final Parameter<Boolean> YIELDS =
            Parameter.flag("yields", false, "Whether it leaves its robot to another agent as long as that drives it.");

    static final Parameter<String> FAULT_KIND = Parameter.choice(
                    "kind", "", words(FaultKind.values(), FaultKind::word), "Kind of fault.")
            .required();
    static final Parameter<Double> AT =
            Parameter.number("at", 0, 0, 1e6, "s", "When it begins; with 'every', the time before which it does not.");
    static final Parameter<Double> EVERY = Parameter.number(
                    "every", 1, 1, 1e6, "s", "Mean time until it begins at random, and again after each end.")
            .required();
    static final Parameter<Double> LONGEST = Parameter.number(
                    "for", 1, 0.01, 1e6, "s", "How long it lasts. Default: permanently.")
            .required();
    static final Parameter<Double> LONGEST_DELAY = Parameter.number(
                    "delay", 1, 0, 600, "s", "How much later a message comes.")
            .required();
    static final Parameter<Integer> PICK = Parameter.integer(
                    "pick", 1, 1, MAX_ROBOTS, "", "How many have it at a time, chosen at random.")
            .required();

    static final Parameter<Double> RANGE = Parameter.number(
                    "range", 15, 0, 1e6, "m", "Distance up to which robots receive messages. Default: any distance.")
            .required();
    static final Parameter<Double> BEHIND_WALLS = Parameter.number(
                    "behindWalls", 5, 0, 1e6, "m", "The same through walls of the map. Default: 'range'.")
            .required();
    static final Parameter<Double> LOSS =
            Parameter.number("loss", 0, 0, 1, "", "Probability that a message is lost, for each receiver.");
    static final Parameter<Double> RADIO_DELAY = Parameter.number("delay", 0, 0, 600, "s", "Delay of a message.");
    static final Parameter<Double> BANDWIDTH = Parameter.number(
                    "bandwidth", 50, 0.01, 1e6, "1/s", "Messages per second that an agent can send. Default: no limit.")
            .required();

    private Format() {}

    /// The groups of a list, each read by itself.
    static List<Section> groups(Section section, String key) {
        List<Value> items = section.list(key).orElse(List.of());
        if (items.size() > MAX_ITEMS) {
            section.problem(
                    key,
                    "'%s' has %d entries; at most %d can be.".formatted(section.path(key), items.size(), MAX_ITEMS),
                    "");
        }
        var groups = new ArrayList<Section>();
        for (Value item : items) {
            if (item instanceof Value.Mapping mapping) {
                groups.add(new Section(section.path(key), mapping, section.problems()));
            } else {
                section.expected(key, "a list of groups {name: value}", item);
            }
        }
        return groups;
    }

    /// A number of seconds, or the least and the most of them.
    static Optional<Span> span(Section section, String key, Parameter<?> seconds, double least) {
        Optional<Value> value = section.find(key);
        if (value.isEmpty()) {
            return Optional.empty();
        }
        if (value.get() instanceof Value.Sequence pair) {
            Optional<double[]> both = section.numbers(key, pair, 2);
            if (both.isPresent()
                    && !(both.get()[0] >= least && both.get()[0] <= both.get()[1] && both.get()[1] <= seconds.max())) {
                section.problem(
                        pair.location(),
                        "'%s' must be [least, most], each %s.".formatted(section.path(key), seconds.expected()),
                        "");
            }
            return both.map(b -> Span.of(b[0], b[1]));
        }
        return section.value(seconds).map(Double.class::cast).map(s -> Span.of(s, s));
    }

    private static <E> List<String> words(E[] values, Function<E, String> word) {
        return Arrays.stream(values).map(word).toList();
    }

    /// The one whose word it is, which [Parameter#accept] has seen to be there.
    static <E> E of(E[] values, Function<E, String> word, Object read) {
        return Arrays.stream(values)
                .filter(value -> word.apply(value).equals(read))
                .findFirst()
                .orElse(values[0]);
    }
}
