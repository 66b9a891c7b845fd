package rsal.ros2.bridge;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rsal.robot.Robot;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.system.BridgeContext;
import rsal.system.RunControl;
import rsal.time.Scheduler;

/// Parameters of a node, as `ros2 param` asks for them. All are read-only: they say how it is.
final class NodeParameters {
    private static final String PACKAGE = "rcl_interfaces/srv/";
    private static final int MOST_NAMES = 1_000; // in a request

    private final String node;
    private final Map<String, Parameter> parameters = new LinkedHashMap<>();

    /// @param description a sentence
    record Parameter(String name, Value value, String description) {}

    /// Those of `rcl_interfaces/ParameterValue` that are in use.
    sealed interface Value {
        record Flag(boolean value) implements Value {}

        record Decimal(double value) implements Value {}

        record Text(String value) implements Value {}
    }

    /// @param node its full name: `/r1/rsal`
    NodeParameters(String node, List<Parameter> parameters) {
        this.node = node;
        parameters.forEach(each -> this.parameters.put(each.name, each));
    }

    /// Of a node that is about no robot.
    static List<Parameter> of(BridgeContext context) {
        boolean isSimulated = context.control().map(RunControl::isPausable).orElse(true);
        double timeout =
                context.timeout().limit().map(limit -> limit.toMillis() / 1e3).orElse(0.0);
        return List.of(
                new Parameter(
                        "use_sim_time",
                        new Value.Flag(isSimulated),
                        "Whether stamps are in simulated time, as '/clock'."),
                new Parameter(
                        "command_timeout",
                        new Value.Decimal(timeout),
                        "After which robots stop when no command comes [s]; 0 for never."));
    }

    /// Of a robot's.
    static List<Parameter> of(Robot robot, BridgeContext context) {
        var all = new ArrayList<>(of(context));
        all.add(new Parameter("robot_id", new Value.Text(robot.id()), "Its id in RSAL."));
        all.add(new Parameter("robot_model", new Value.Text(robot.model().name()), "Its model in RSAL."));
        all.add(new Parameter("robot_role", new Value.Text(robot.role()), "Its role in the scenario."));
        return List.copyOf(all);
    }

    /// Serves them until the node's link is closed.
    ///
    /// @param link the node's
    /// @param run on whose thread requests are answered
    void serve(RosLink link, Executor run, Scheduler scheduler) {
        var services = new Services(link, TypeLibrary.of(Distribution.JAZZY), run);
        serve(services, "get_parameters", "GetParameters", this::get);
        serve(services, "get_parameter_types", "GetParameterTypes", this::types);
        serve(services, "describe_parameters", "DescribeParameters", this::describe);
        serve(services, "list_parameters", "ListParameters", this::list);
        serve(services, "set_parameters", "SetParameters", this::set);
        serve(services, "set_parameters_atomically", "SetParametersAtomically", this::setAll);
        link.advertise(new RosTopic("/parameter_events", "rcl_interfaces/msg/ParameterEvent"), Profile.DEFAULT)
                .publish(event(scheduler));
    }

    private interface Answer {
        void write(RosMessage request, CdrWriter response);
    }

    private void serve(Services services, String name, String type, Answer answer) {
        services.serve(node + "/" + name, PACKAGE + type, request -> {
            var response = new CdrWriter();
            answer.write(request, response);
            return response.toBytes();
        });
    }

    /// That it has them, for those who listen already.
    private byte[] event(Scheduler scheduler) {
        CdrWriter event = RosMessages.write(new CdrWriter(), scheduler.instant());
        event.text(node).int32(parameters.size());
        for (Parameter each : parameters.values()) {
            write(each.value, event.text(each.name));
        }
        return event.int32(0).int32(0).toBytes(); // none was changed or deleted
    }

    private static int type(Value value) {
        return switch (value) {
            case Value.Flag _ -> 1;
            case Value.Decimal _ -> 3;
            case Value.Text _ -> 4;
        };
    }

    private static void write(Value value, CdrWriter to) {
        write(
                to,
                type(value),
                value instanceof Value.Flag(boolean flag) && flag,
                value instanceof Value.Decimal(double number) ? number : 0,
                value instanceof Value.Text(String text) ? text : "");
    }

    private static void write(CdrWriter to, int type, boolean flag, double number, String text) {
        to.int8((byte) type).bool(flag).int64(0).float64(number).text(text);
        for (int i = 0; i < 5; i++) { // sequences of each kind
            to.int32(0);
        }
    }

    private static List<String> names(RosMessage request) {
        List<?> names = request.get("names", List.class);
        return names.stream().limit(MOST_NAMES).map(String.class::cast).toList();
    }

    private static <T> void all(Collection<T> all, CdrWriter to, Consumer<T> write) {
        to.int32(all.size());
        all.forEach(write);
    }

    private void get(RosMessage request, CdrWriter response) {
        all(names(request), response, name -> {
            Parameter known = parameters.get(name);
            if (known == null) {
                write(response, 0, false, 0, ""); // not set
            } else {
                write(known.value, response);
            }
        });
    }

    private int type(String name) {
        Parameter known = parameters.get(name);
        return known == null ? 0 : type(known.value);
    }

    private void types(RosMessage request, CdrWriter response) {
        all(names(request), response, name -> response.int8((byte) type(name)));
    }

    private void describe(RosMessage request, CdrWriter response) {
        all(names(request), response, name -> {
            Parameter known = parameters.get(name);
            response.text(name)
                    .int8((byte) type(name))
                    .text(known == null ? "" : known.description)
                    .text("") // other constraints
                    .bool(known != null) // read-only
                    .bool(false) // typed dynamically
                    .int32(0) // no ranges
                    .int32(0);
        });
    }

    /// Names have no dots, so that a prefix is a name, and each depth is deep enough.
    private void list(RosMessage request, CdrWriter response) {
        List<?> prefixes = request.get("prefixes", List.class);
        List<String> wanted = parameters.keySet().stream()
                .filter(name -> prefixes.isEmpty() || prefixes.contains(name))
                .toList();
        all(wanted, response, response::text);
        response.int32(0);
    }

    private String refusal(RosMessage parameter) {
        String name = parameter.text("name");
        return parameters.containsKey(name)
                ? "Parameter '%s' is read-only.".formatted(name)
                : "There is no parameter '%s', but %s.".formatted(name, String.join(", ", parameters.keySet()));
    }

    private void set(RosMessage request, CdrWriter response) {
        List<RosMessage> wanted =
                request.messages("parameters").stream().limit(MOST_NAMES).toList();
        all(wanted, response, each -> response.bool(false).text(refusal(each)));
    }

    private void setAll(RosMessage request, CdrWriter response) {
        List<RosMessage> wanted = request.messages("parameters");
        response.bool(wanted.isEmpty()).text(wanted.isEmpty() ? "" : refusal(wanted.getFirst()));
    }
}
