package rsal.ros2.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import rsal.device.Device;
import rsal.device.Gripper;
import rsal.robot.RobotModel.Part;
import rsal.ros2.link.RosLink;
import rsal.time.Scheduler;

/// Kinds of devices that take goals of others if a robot has them, beside those that [PublishedRobot] itself knows.
final class GoalServers {
    private static final List<Kind<?>> ALL = List.of(new Kind<>(Gripper.class, GoalServers::serve));

    private GoalServers() {}

    /// Where goals come in.
    ///
    /// @param outlet of the robot
    /// @param link of its node
    /// @param services makes new ones, which their user closes
    record Context(RobotOutlet outlet, RosLink link, Supplier<Services> services, Scheduler scheduler) {
        String name(String name) {
            return outlet.topic(name, "").name();
        }
    }

    /// Serves a device.
    interface Serving<D extends Device> {
        /// @return the names under which it is served, in the robot's namespace
        List<Served> serve(D device, Context context);
    }

    /// @param name in the robot's namespace
    /// @param close ends it
    record Served(Device device, String name, Runnable close) {}

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
        if (context.outlet.robot().model().sensors().get(gripper.info().name()) instanceof Part.Gripper part) {
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
                gripper, motion, context.link, context.services.get(), context.name(name), context.scheduler);
        return new Served(gripper, name, action::close);
    }
}
