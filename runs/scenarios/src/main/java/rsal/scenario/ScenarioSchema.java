package rsal.scenario;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.robot.DeviceDriver;
import rsal.scenario.fault.FaultKind;
import rsal.scenario.installed.Catalog;
import rsal.settings.Parameter;
import rsal.settings.Plugin;
import rsal.settings.PluginKind;
import rsal.system.RobotSystemProvider;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

/// The scenario format as a JSON Schema (2020-12), for editors. It knows what can be named in this installation,
/// and which settings that takes. What one part of a scenario says about another (roles, arguments, poses and
/// walls) is beyond it: that is checked by [Scenario#check].
///
/// Longer than 500 lines, since it is a list: a method for each section of a scenario.
public final class ScenarioSchema {
    private static final String ARGUMENT = "#/$defs/argument";
    private static final String DEVICE = "#/$defs/device";
    private static final String FAULT = "#/$defs/fault";

    private final Catalog catalog;

    ScenarioSchema(Catalog catalog) {
        this.catalog = catalog;
    }

    /// The schema for what is installed, as JSON.
    public static String json() {
        return new ScenarioSchema(Catalog.installed()).write();
    }

    String write() {
        var mapper =
                JsonMapper.builder().enable(SerializationFeature.INDENT_OUTPUT).build();
        return mapper.writeValueAsString(schema()).replace("\r\n", "\n") + "\n";
    }

    private Map<String, Object> schema() {
        var schema = new LinkedHashMap<String, Object>();
        schema.put("$schema", "https://json-schema.org/draft/2020-12/schema");
        schema.put("title", "RSAL scenario");
        schema.putAll(group(
                with(
                        fields(
                                "rsal", described(Map.of("const", Format.VERSION), "Version of the format."),
                                "scenario", described(text(), "Name of the scenario."),
                                "title", described(text(), "A line for people."),
                                "description", described(text(), "Some sentences for people."),
                                "arguments",
                                        described(
                                                named(argument()),
                                                "Arguments that can be set when the scenario is started.")),
                        with(
                                body(false),
                                fields(
                                        "configurations",
                                        described(named(configuration()), "Variants; the first is the default.")))),
                List.of("rsal", "scenario", "world")));
        schema.put(
                "anyOf",
                List.of(
                        fields("required", List.of("robots")),
                        fields("properties", fields("world", fields("required", List.of("file"))))));
        schema.put("$defs", definitions());
        return schema;
    }

    private Map<String, Object> definitions() {
        var definitions = fields(
                "argument",
                fields(
                        "description", "Stands for the value of an argument.",
                        "type", "string",
                        "pattern", "^\\$[A-Za-z][A-Za-z0-9_-]*$"));
        var devices = new ArrayList<Object>(List.of(knownDevices(), text()));
        catalog.drivers().forEach((key, driver) -> {
            definitions.put("driver-" + key, driver(key, driver));
            devices.add(fields("allOf", List.of(driver(key), fields("required", List.of("type")))));
        });
        definitions.put("device", anyOf(devices));
        definitions.put("fault", fault());
        return definitions;
    }

    private static Map<String, Object> argument() {
        var numeric = fields(
                "type", fields("enum", List.of("integer", "number")),
                "default", fields("type", "number"),
                "min", fields("type", "number"),
                "max", fields("type", "number"));
        var words = fields(
                "type", fields("const", "string"),
                "default", fields("type", "string"),
                "enum", fields("type", "array", "items", fields("type", "string")));
        var flag = fields("type", fields("const", "boolean"), "default", fields("type", "boolean"));
        var common = fields("unit", fields("type", "string"), "description", fields("type", "string"));
        var required = List.of("type", "default");
        return oneOf(List.of(
                group(with(numeric, common), required),
                group(with(words, common), required),
                group(with(flag, common), required)));
    }

    private Map<String, Object> configuration() {
        var more = fields(
                "title",
                described(text(), "A line for people."),
                Format.ARGUMENTS,
                described(
                        fields(
                                "type",
                                "object",
                                "additionalProperties",
                                fields("type", List.of("string", "number", "boolean"))),
                        "Values for the scenario's arguments."));
        return group(with(more, body(true)), List.of());
    }

    /// What a configuration can change.
    ///
    /// @param partial whether it lies over something and may leave out anything
    private Map<String, Object> body(boolean partial) {
        return fields(
                "world",
                described(world(partial), "A map, or the file of a complete world."),
                "robots",
                described(
                        named(role(partial)),
                        "Robots by their role, at most %d; required unless the world has robots."
                                .formatted(Format.MAX_ROBOTS)),
                "things",
                described(named(thing(partial)), "Objects in the simulated world, in addition to robots."),
                "places",
                described(named(place()), "Areas that conditions and metrics name."),
                "agents",
                described(named(agent(partial)), "Agents, which decide for robots and teams."),
                JoinReader.KEY,
                joined(),
                "mas",
                described(
                        backEnd(
                                partial,
                                Format.DEFAULT_MAS,
                                parameters(catalog.hosts(), AgentHostProvider::parameters)),
                        "Multi-agent system. Default: '%s'.".formatted(Format.DEFAULT_MAS)),
                "mrs",
                described(systems(partial), "Robot system. Default: '%s'.".formatted(Format.DEFAULT_MRS)),
                "communication",
                communication(),
                "faults",
                described(list(fields("$ref", FAULT)), "Faults of robots, sensors and messages."),
                "run",
                described(run(), "Seed, clock and stop conditions."),
                MetricReader.KEY,
                described(
                        list(metricType()),
                        "Types of metrics in your own files, and parameters of installed" + " ones."),
                "metrics",
                described(list(metric()), "Metrics of each run."));
    }

    private Map<String, Object> systems(boolean partial) {
        return backEnd(partial, Format.DEFAULT_MRS, parameters(catalog.systems(), RobotSystemProvider::parameters));
    }

    private static Map<String, Object> joined() {
        var args = fields(
                "type", "object", "additionalProperties", fields("type", List.of("string", "number", "boolean")));
        return described(
                anyOf(List.of(
                        text(),
                        group(
                                fields(
                                        "scenario",
                                        described(text(), "SCENARIO or SCENARIO:CONFIGURATION."),
                                        Format.ARGUMENTS,
                                        described(args, "Values for its arguments."),
                                        "robots",
                                        described(
                                                named(text()),
                                                "The role of this scenario for each of its roles; may be omitted if"
                                                        + " this scenario has one role.")),
                                List.of("scenario")))),
                "Another scenario, whose agents without a robot join this one.");
    }

    private Map<String, Object> world(boolean partial) {
        var touch = parameter(Format.ON_COLLISION);
        var either = fields("map", map(), "file", file(), "onCollision", touch);
        if (partial) {
            return group(either, List.of());
        }
        return oneOf(List.of(
                group(fields("map", map(), "onCollision", touch), List.of("map")),
                group(fields("file", file(), "onCollision", touch), List.of("file"))));
    }

    private Map<String, Object> file() {
        String suffixes = catalog.formats().keySet().stream()
                .map(suffix -> suffix.replace(".", "\\."))
                .collect(Collectors.joining("|"));
        return described(
                anyOf(List.of(fields("type", "string", "pattern", "(" + suffixes + ")$"), reference())),
                "The file of a world, with all that is in it.");
    }

    private Map<String, Object> map() {
        return described(
                anyOf(List.of(
                        enumeration(catalog.maps()), fields("type", "string", "pattern", "\\.ya?ml$"), reference())),
                "A map that comes with the program, or the YAML file of a map in ROS's format.");
    }

    /// Robots that are counted, or named one by one: then each may say what else it has than its role.
    private Map<String, Object> role(boolean partial) {
        Map<String, Object> member =
                group(with(fields("name", described(name(), "Id of the robot.")), robot(true)), List.of());
        Map<String, Object> role = group(
                with(
                        fields("count", parameter(Format.COUNT)),
                        with(
                                robot(partial),
                                fields(
                                        RobotReader.MEMBERS,
                                        described(
                                                list(member),
                                                "Robots one by one, each with what it has otherwise than its role.")))),
                List.of());
        if (!partial) {
            role.put(
                    "anyOf",
                    List.of(fields("required", List.of("model")), fields("required", List.of(RobotReader.MEMBERS))));
        }
        return role;
    }

    private Map<String, Object> robot(boolean partial) {
        return fields(
                "model",
                described(
                        anyOf(List.of(
                                enumeration(catalog.models()),
                                fields("type", "string", "pattern", "\\.ya?ml$"),
                                reference())),
                        "What kind of robot it is."),
                "pose",
                described(
                        anyOf(List.of(poses(partial), fields("const", RobotReader.OPEN))),
                        "Where they start: [x, y, degrees], a list of those, somewhere free, or auto"
                                + " where the robot system or the localizer knows."),
                "color",
                described(color(), "How people see them."),
                "fiducial",
                parameter(Format.FIDUCIAL),
                Format.PROXY.name(),
                parameter(Format.PROXY),
                Format.OVERLAY.name(),
                parameter(Format.OVERLAY),
                SystemReader.KEY,
                described(
                        systems(true),
                        "Which robot system they are of, or what they have of the scenario's otherwise."),
                "devices",
                devices(partial));
    }

    private static Map<String, Object> name() {
        return orReference(fields("type", "string", "pattern", "^" + Format.NAME.pattern() + "$"));
    }

    private static Map<String, Object> thing(boolean partial) {
        return group(
                fields(
                        "count", parameter(Format.COUNT),
                        "pose",
                                described(
                                        poses(partial),
                                        "Their poses: [x, y, degrees], a list of these, or a free place."),
                        "body", described(fields("type", "object"), "A box, a disc, an outline, or pieces of these."),
                        "color", described(color(), "Their color for cameras."),
                        "obstacle", parameter(Format.OBSTACLE),
                        "grippable", parameter(Format.GRIPPABLE),
                        "fiducial", parameter(Format.FIDUCIAL),
                        "givingPower", parameter(Format.GIVING_POWER),
                        "every", parameter(Format.COMES_EVERY),
                        "depot",
                                described(
                                        group(
                                                fields(
                                                        "around", described(text(), "Where robots of a role start."),
                                                        "at",
                                                                fields(
                                                                        "type",
                                                                        "array",
                                                                        "items",
                                                                        numbers(2),
                                                                        "minItems",
                                                                        1),
                                                        "radius", parameter(Format.DEPOT_RADIUS)),
                                                List.of()),
                                        "Place to which they have to be brought."),
                        "reach",
                                described(
                                        group(
                                                fields(
                                                        "by", described(text(), "Role of the robots, or all."),
                                                        "within", parameter(Format.WITHIN),
                                                        "duration", parameter(Format.DURATION)),
                                                partial ? List.of() : List.of("by")),
                                        "Robots that have to reach each of them.")),
                partial ? List.of() : List.of("pose", "body"));
    }

    private static Map<String, Object> place() {
        return group(
                fields(
                        "at", described(numbers(2), "x and y of its middle [m]."),
                        "radius", parameter(Format.PLACE_RADIUS),
                        "within", rectangle()),
                List.of());
    }

    private static Map<String, Object> rectangle() {
        return described(numbers(4), "Least x, least y, greatest x, greatest y [m].");
    }

    private static Map<String, Object> poses(boolean partial) {
        Map<String, Object> pose = numbers(3);
        return anyOf(List.of(
                pose,
                fields("type", "array", "items", pose, "minItems", 1),
                partial ? fields("type", "object") : free()));
    }

    private static Map<String, Object> numbers(int count) {
        var number = orReference(fields("type", "number"));
        return fields("type", "array", "items", number, "minItems", count, "maxItems", count);
    }

    private static Map<String, Object> color() {
        return orReference(fields("type", "string", "pattern", "^(#[0-9a-fA-F]{6}|[a-zA-Z][a-zA-Z0-9 ]*)$"));
    }

    private static Map<String, Object> free() {
        return group(
                fields(
                        "free", fields("const", true),
                        "clearance", parameter(Format.CLEARANCE),
                        "passage", parameter(Format.PASSAGE),
                        "within", rectangle()),
                List.of("free"));
    }

    private Map<String, Object> devices(boolean partial) {
        String description =
                "Parts (laser: urg04lx) and drivers of software devices (localizer: {type: amcl}), in order.";
        if (partial) {
            return described(
                    fields(
                            "type",
                            "object",
                            "additionalProperties",
                            anyOf(List.of(knownDevices(), fields("type", List.of("string", "object"))))),
                    description);
        }
        var byName = new LinkedHashMap<String, Object>();
        catalog.drivers().keySet().forEach(key -> byName.put(key, anyOf(List.of(fields("$ref", DEVICE), driver(key)))));
        return described(
                fields("type", "object", "properties", byName, "additionalProperties", fields("$ref", DEVICE)),
                description);
    }

    /// Words that name one by themselves: parts that come with the program, and drivers.
    private Map<String, Object> knownDevices() {
        var words = new ArrayList<>(catalog.parts());
        words.addAll(catalog.drivers().keySet());
        return enumeration(words);
    }

    private static Map<String, Object> driver(String key) {
        return fields("$ref", "#/$defs/driver-" + key);
    }

    /// The type may be left out for a device of the driver's own name.
    private static Map<String, Object> driver(String key, DeviceDriver driver) {
        return group(with(fields("type", fields("const", key)), parameters(driver.parameters())), List.of());
    }

    private Map<String, Object> agent(boolean partial) {
        var robot = fields(
                "robot", described(text(), "Role of the robots that have one each."),
                "yields", parameter(Format.YIELDS));
        var anything = group(
                with(fields("type", text()), with(robot, fields(Format.PARAMETERS, fields("type", "object")))),
                List.of());
        if (partial) {
            return anything;
        }
        var kinds = new ArrayList<Object>();
        catalog.agents().forEach((key, type) -> kinds.add(agent(key, type, robot)));
        kinds.add(anyAgent(reference(), robot));
        catalog.languages().values().stream()
                .map(AgentLanguage::pattern)
                .forEach(pattern -> kinds.add(described(
                        anyAgent(fields("type", "string", "pattern", pattern), robot),
                        "File of an agent of your own.")));
        return oneOf(kinds);
    }

    /// An agent whose arguments only its own file tells.
    private static Map<String, Object> anyAgent(Map<String, Object> type, Map<String, Object> robot) {
        return group(
                with(fields("type", type), with(robot, fields(Format.PARAMETERS, fields("type", "object")))),
                List.of("type"));
    }

    private static Map<String, Object> agent(String key, AgentType type, Map<String, Object> robot) {
        return described(
                group(
                        with(
                                fields("type", fields("const", key)),
                                with(
                                        robot,
                                        fields(
                                                Format.PARAMETERS,
                                                group(parameters(type.parameters()), required(type.parameters()))))),
                        required(type.parameters()).isEmpty() ? List.of("type") : List.of("type", Format.PARAMETERS)),
                type.description());
    }

    private static <P> Map<String, List<Parameter<?>>> parameters(
            Map<String, P> providers, Function<P, List<Parameter<?>>> parameters) {
        var byKey = new LinkedHashMap<String, List<Parameter<?>>>();
        providers.forEach((key, provider) -> byKey.put(key, parameters.apply(provider)));
        return byKey;
    }

    private static Map<String, Object> backEnd(
            boolean partial, String fallback, Map<String, List<Parameter<?>>> parameters) {
        var kinds = new ArrayList<Object>();
        parameters.forEach((key, own) -> kinds.add(group(
                with(fields("use", fields("const", key)), parameters(own)),
                partial || key.equals(fallback) ? List.of() : List.of("use"))));
        return anyOf(kinds);
    }

    private static Map<String, Object> run() {
        var clock = fields(
                "mode", parameter(Format.MODE),
                "speed", anyOf(List.of(parameter(Format.SPEED), fields("const", "max"))));
        var stop = group(
                fields(
                        "when", described(text(), "A condition, like allCaught(prey) or time > 300."),
                        "outcome", parameter(Format.OUTCOME),
                        "after", parameter(Format.AFTER)),
                List.of("when", "outcome"));
        return group(
                fields(
                        "seed", parameter(Format.SEED),
                        "clock", group(clock, List.of()),
                        "stop", list(stop),
                        "failedAgents", parameter(Format.FAILED_AGENTS)),
                List.of());
    }

    private static Map<String, Object> communication() {
        return described(
                group(
                        fields(
                                "range", parameter(Format.RANGE),
                                "behindWalls", parameter(Format.BEHIND_WALLS),
                                "loss", parameter(Format.LOSS),
                                "delay", span(Format.RADIO_DELAY),
                                "bandwidth", parameter(Format.BANDWIDTH)),
                        List.of()),
                "Limits of communication between agents; RSAL then records received and lost messages. Default: no"
                        + " limits.");
    }

    private static Map<String, Object> fault() {
        return oneOf(
                Arrays.stream(FaultKind.values()).map(ScenarioSchema::fault).toList());
    }

    private static Map<String, Object> fault(FaultKind kind) {
        var timing = fields(
                "kind", fields("const", kind.word()),
                "at", parameter(Format.AT),
                "every", parameter(Format.EVERY),
                "for", span(Format.LONGEST));
        var whom = switch (kind.of()) {
            case SENSORS ->
                fields(
                        "robots", names("Roles or ids of robots, patterns (r*), all, or any for one of them."),
                        "devices", names("Names or types of sensors, patterns, or all."),
                        "pick", parameter(Format.PICK));
            case BASES, ROBOTS ->
                fields(
                        "robots", names("Roles or ids of robots, patterns (r*), all, or any for one of them."),
                        "pick", parameter(Format.PICK));
            case MESSAGES ->
                fields(
                        "topics", names("Names or patterns of topics, or all."),
                        "from", names("Agents that speak, robots that have one, roles of either, patterns, or all."),
                        "to", names("Agents that listen."));
        };
        kind.delay().ifPresent(_ -> whom.put("delay", span(Format.LONGEST_DELAY)));
        List<String> required = switch (kind.of()) {
            case SENSORS -> List.of("kind", "robots", "devices");
            case BASES, ROBOTS -> List.of("kind", "robots");
            case MESSAGES -> List.of("kind");
        };
        return described(group(with(timing, with(whom, parameters(kind.parameters()))), required), kind.description());
    }

    private static Map<String, Object> names(String description) {
        return described(anyOf(List.of(text(), fields("type", "array", "items", text()))), description);
    }

    /// A number of seconds, or the least and the most.
    private static Map<String, Object> span(Parameter<?> seconds) {
        Map<String, Object> one = parameter(seconds);
        return described(
                anyOf(List.of(one, fields("type", "array", "items", one, "minItems", 2, "maxItems", 2))),
                description(seconds) + " A list is the least and the most.");
    }

    private static Map<String, Object> metricType() {
        return group(
                fields(
                        "type",
                        described(text(), "A metric by its name, or a file: Spacing.java."),
                        Format.PARAMETERS,
                        described(fields("type", "object"), "Values for its parameters.")),
                List.of("type"));
    }

    private static Map<String, Object> metric() {
        return group(
                fields(
                        "name", fields("type", "string", "pattern", "^" + Format.NAME.pattern() + "$"),
                        "unit", fields("type", "string"),
                        "from", described(text(), "What to measure, like p95(poseError)."),
                        "per", parameter(Format.PER),
                        "better", parameter(Format.BETTER),
                        "bound",
                                group(
                                        fields(
                                                "min", orReference(fields("type", "number")),
                                                "max", orReference(fields("type", "number"))),
                                        List.of())),
                List.of("name", "from"));
    }

    private static Map<String, Object> parameters(List<Parameter<?>> parameters) {
        var properties = new LinkedHashMap<String, Object>();
        parameters.forEach(parameter -> properties.put(parameter.name(), parameter(parameter)));
        return properties;
    }

    private static List<String> required(List<Parameter<?>> parameters) {
        return parameters.stream()
                .filter(parameter -> parameter.fallback().isEmpty())
                .map(Parameter::name)
                .toList();
    }

    /// A plugin by its name or file, or a group with its parameters.
    private static Map<String, Object> plugin(Parameter<?> parameter) {
        var schema = plugin(parameter.plugins().orElseThrow());
        parameter.fallback().ifPresent(fallback -> schema.put("default", fallback.toString()));
        return described(schema, description(parameter));
    }

    /// One plugin, or several in an order.
    private static Map<String, Object> plugins(Parameter<?> parameter) {
        var one = plugin(parameter.plugins().orElseThrow());
        var schema = anyOf(List.of(one, fields("type", "array", "items", one)));
        parameter.fallback().ifPresent(fallback -> schema.put("default", keys(fallback)));
        return described(schema, description(parameter));
    }

    private static List<String> keys(Object choices) {
        return ((List<?>) choices).stream().map(String::valueOf).toList();
    }

    private static Map<String, Object> plugin(PluginKind kind) {
        var file = described(fields("type", "string", "pattern", "\\.java$"), "A file beside the scenario.");
        var choices = new ArrayList<Object>(List.of(
                enumeration(kind.keys()),
                file,
                fields("type", "object", "properties", fields("type", file), "required", List.of("type"))));
        for (Plugin plugin : kind.all()) {
            var required = new ArrayList<>(List.of("type"));
            required.addAll(required(plugin.parameters()));
            choices.add(described(
                    group(
                            with(fields("type", fields("const", plugin.key())), parameters(plugin.parameters())),
                            required),
                    plugin.description()));
        }
        choices.add(reference());
        return anyOf(choices);
    }

    private static Map<String, Object> parameter(Parameter<?> parameter) {
        if (parameter.kind() == Parameter.Kind.PLUGIN) {
            return plugin(parameter);
        }
        if (parameter.kind() == Parameter.Kind.PLUGINS) {
            return plugins(parameter);
        }
        var value = new LinkedHashMap<String, Object>();
        value.put(
                "type",
                switch (parameter.kind()) {
                    case NUMBER -> "number";
                    case INTEGER -> "integer";
                    case TEXT, ROBOTS, PLACES, POINTS -> "string";
                    case FLAG -> "boolean";
                    case TEXTS -> "object";
                    case PLUGIN, PLUGINS -> throw new IllegalArgumentException("It has several types.");
                });
        if (Double.isFinite(parameter.min())) {
            value.put("minimum", parameter.min());
        }
        if (Double.isFinite(parameter.max())) {
            value.put("maximum", parameter.max());
        }
        if (parameter.kind() == Parameter.Kind.TEXT && !parameter.options().isEmpty()) {
            value.put("enum", parameter.options());
        }
        var schema = orReference(value);
        Optional<Object> fallback = parameter.fallback();
        fallback.ifPresent(f -> schema.put("default", f));
        return described(schema, description(parameter));
    }

    private static String description(Parameter<?> parameter) {
        return parameter.description() + (parameter.unit().isEmpty() ? "" : " [" + parameter.unit() + "]");
    }

    private static Map<String, Object> orReference(Map<String, Object> schema) {
        return anyOf(List.of(schema, reference()));
    }

    private static Map<String, Object> reference() {
        return fields("$ref", ARGUMENT);
    }

    private static Map<String, Object> text() {
        return fields("type", "string", "minLength", 1);
    }

    private static Map<String, Object> enumeration(List<String> words) {
        return fields("enum", words);
    }

    private static Map<String, Object> anyOf(List<?> schemas) {
        return fields("anyOf", schemas);
    }

    private static Map<String, Object> oneOf(List<?> schemas) {
        return fields("oneOf", schemas);
    }

    private static Map<String, Object> list(Map<String, Object> items) {
        return fields("type", "array", "items", items, "maxItems", Format.MAX_ITEMS);
    }

    /// A group whose names are free to choose.
    private static Map<String, Object> named(Map<String, Object> each) {
        return fields(
                "type",
                "object",
                "propertyNames",
                fields("pattern", "^" + Format.NAME.pattern() + "$"),
                "additionalProperties",
                each);
    }

    private static Map<String, Object> group(Map<String, Object> properties, List<String> required) {
        var group = fields("type", "object", "properties", properties);
        if (!required.isEmpty()) {
            group.put("required", required);
        }
        group.put("additionalProperties", false);
        return group;
    }

    private static Map<String, Object> described(Map<String, Object> schema, String description) {
        var described = fields("description", description);
        described.putAll(schema);
        return described;
    }

    private static Map<String, Object> with(Map<String, Object> first, Map<String, Object> more) {
        var all = new LinkedHashMap<>(first);
        all.putAll(more);
        return all;
    }

    /// Names and values in turn.
    private static Map<String, Object> fields(Object... namesAndValues) {
        var fields = new LinkedHashMap<String, Object>();
        for (int i = 0; i < namesAndValues.length; i += 2) {
            fields.put((String) namesAndValues[i], namesAndValues[i + 1]);
        }
        return fields;
    }
}
