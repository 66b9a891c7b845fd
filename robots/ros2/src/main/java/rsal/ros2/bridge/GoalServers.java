package rsal.ros2.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import rsal.data.OccupancyGrid;
import rsal.device.Device;
import rsal.device.Docking;
import rsal.device.Gripper;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.robot.RobotModel.Part;
import rsal.ros2.action.Services;
import rsal.ros2.link.RosLink;
import rsal.ros2.simulation.PublishedTime;

/// Kinds of devices that take goals of others if a robot has them.
final class GoalServers {
    private static final List<Kind<?>> ALL = List.of(
            new Kind<>(Gripper.class, GoalServers::serve),
            new Kind<>(Navigator.class, GoalServers::serve),
            new Kind<>(Planner.class, GoalServers::serve),
            new Kind<>(Docking.class, GoalServers::serve));
    private static final String NAVIGATE = "navigate_to_pose";
    private static final String THROUGH = "navigate_through_poses";
    private static final String PLAN = "compute_path_to_pose";
    private static final String DOCK = "dock_robot";
    private static final String UNDOCK = "undock_robot";

    private GoalServers() {}

    /// Where goals come in.
    ///
    /// @param outlet of the robot
    /// @param map of all robots
    /// @param link of its node
    /// @param services makes new ones on a link, which their user closes
    /// @param nodes makes active ones, by their names, which their user closes
    record Context(
            RobotOutlet outlet,
            OccupancyGrid map,
            RosLink link,
            Function<RosLink, Services> services,
            Function<String, ActiveNode> nodes,
            PublishedTime scheduler) {
        String name(String name) {
            return outlet.topic(name, "").name();
        }

        Robot robot() {
            return outlet.robot();
        }
    }

    /// Serves a device.
    interface Serving<D extends Device> {
        /// @return the names under which it is served, in the robot's namespace
        List<Served> serve(D device, Context context);
    }

    /// @param name in the robot's namespace
    /// @param abort ends its goals
    /// @param close ends it
    record Served(Device device, String name, Runnable abort, Runnable close) {}

    private record Kind<D extends Device>(Class<D> type, Serving<D> serving) {
        List<Served> serve(Device device, Context context) {
            return type.isInstance(device) ? serving.serve(type.cast(device), context) : List.of();
        }
    }

    static List<Served> serve(Device device, Context context) {
        return ALL.stream()
                .flatMap(kind -> kind.serve(device, context).stream())
                .toList();
    }

    /// Sizes are those of the model; without them positions mean nothing.
    private static List<Served> serve(Gripper gripper, Context context) {
        var served = new ArrayList<Served>();
        if (context.robot().model().sensors().get(gripper.info().name()) instanceof Part.Gripper part) {
            var names = GripperNames.of(gripper, context.outlet);
            var paddles = new PublishedGripper.Motion(
                    part.opening(), Gripper::close, Gripper::open, state -> GripperPublication.gap(part, state), true);
            served.add(serve(gripper, paddles, names.paddles(), context));
            if (part.hasLift()) {
                var lift = new PublishedGripper.Motion(
                        part.height(),
                        Gripper::lower,
                        Gripper::lift,
                        state -> GripperPublication.height(part, state),
                        false);
                served.add(serve(gripper, lift, names.lift(), context));
            }
        }
        return served;
    }

    private static Served serve(Gripper gripper, PublishedGripper.Motion motion, String name, Context context) {
        var action = new PublishedGripper(
                gripper,
                motion,
                context.link,
                context.services.apply(context.link),
                context.name(name),
                context.scheduler);
        return new Served(gripper, name, action::abortAll, action::close);
    }

    private static boolean isFirst(Device device, Class<? extends Device> kind, Context context) {
        return context.robot().find(kind).filter(device::equals).isPresent();
    }

    /// The first one, in a node of the name that Nav2's has.
    private static List<Served> serve(Navigator navigator, Context context) {
        if (!isFirst(navigator, Navigator.class, context)) {
            return List.of();
        }
        ActiveNode node = context.nodes.apply("bt_navigator");
        var action = new PublishedNavigator(
                navigator, node.link(), context.services.apply(node.link()), context.name(NAVIGATE), context.scheduler);
        var route = new PublishedRoute(
                navigator, node.link(), context.services.apply(node.link()), context.name(THROUGH), context.scheduler);
        return List.of(
                new Served(navigator, NAVIGATE, action::abortAll, action::close),
                new Served(navigator, THROUGH, route::abortAll, () -> {
                    route.close();
                    node.close();
                }));
    }

    /// All planners of a robot are served together.
    private static List<Served> serve(Planner planner, Context context) {
        if (!isFirst(planner, Planner.class, context)) {
            return List.of();
        }
        ActiveNode node = context.nodes.apply("planner_server");
        var action = new PublishedPlanner(
                context.robot(),
                context.map,
                node.link(),
                context.services.apply(node.link()),
                context.name(PLAN),
                context.scheduler);
        return List.of(new Served(planner, PLAN, action::abortAll, () -> {
            action.close();
            node.close();
        }));
    }

    /// The first one, in a node of the name that Nav2's has.
    private static List<Served> serve(Docking docking, Context context) {
        if (!isFirst(docking, Docking.class, context)) {
            return List.of();
        }
        ActiveNode node = context.nodes.apply("docking_server");
        var actions = new PublishedDocking(
                docking,
                node.link(),
                () -> context.services.apply(node.link()),
                context.name(DOCK),
                context.name(UNDOCK),
                context.scheduler);
        return List.of(
                new Served(docking, DOCK, actions::abortAll, actions::close),
                new Served(docking, UNDOCK, () -> {}, node::close));
    }
}
