package rsal.ros2.bridge;

import java.util.List;
import java.util.concurrent.Executor;
import rsal.ros2.action.Services;
import rsal.ros2.bridge.NodeParameters.Parameter;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;

/// A node with a lifecycle, as those of Nav2 are, under their names: who waits until Nav2 is active finds it
/// so. It is active for as long as it is there, and can't be taken to another state.
final class ActiveNode {
    private static final String PACKAGE = "lifecycle_msgs/srv/";
    private static final String TRANSITIONS = PACKAGE + "GetAvailableTransitions";
    private static final byte ACTIVE = 3;

    private final RosLink node;

    /// @param link on which the node is opened
    /// @param namespace `/r1`
    /// @param name `bt_navigator`
    /// @param run on whose thread requests are answered
    ActiveNode(
            RosLink link,
            String namespace,
            String name,
            List<Parameter> parameters,
            Executor run,
            Scheduler scheduler) {
        node = link.node(namespace, name);
        String fullName = namespace + "/" + name;
        new NodeParameters(fullName, parameters).serve(node, run, scheduler);
        var services = new Services(node, TypeLibrary.of(Distribution.JAZZY), run);
        services.serve(fullName + "/get_state", PACKAGE + "GetState", _ -> active(new CdrWriter()));
        services.serve(
                fullName + "/change_state",
                PACKAGE + "ChangeState",
                _ -> new CdrWriter().bool(false).toBytes());
        services.serve(
                fullName + "/get_available_states",
                PACKAGE + "GetAvailableStates",
                _ -> active(new CdrWriter().int32(1)));
        services.serve(fullName + "/get_available_transitions", TRANSITIONS, _ -> none());
        services.serve(fullName + "/get_transition_graph", TRANSITIONS, _ -> none());
        node.advertise(
                new RosTopic(fullName + "/transition_event", "lifecycle_msgs/msg/TransitionEvent"), Profile.DEFAULT);
    }

    private static byte[] active(CdrWriter response) {
        return response.int8(ACTIVE).text("active").toBytes();
    }

    private static byte[] none() {
        return new CdrWriter().int32(0).toBytes();
    }

    /// Its link, for what else it offers.
    RosLink link() {
        return node;
    }

    void close() {
        node.close();
    }
}
