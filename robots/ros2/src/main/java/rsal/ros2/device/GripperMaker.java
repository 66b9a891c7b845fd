package rsal.ros2.device;

import java.util.ArrayList;
import java.util.Optional;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.ros2.action.ActionClient;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;

/// Makes a gripper of an action of type `control_msgs/GripperCommand`, and of what else is known of it: its lift,
/// `joint_states`, beams and contacts.
final class GripperMaker implements RosParts.Maker {
    private static final String ACTION = "control_msgs/action/GripperCommand";
    private static final String JOINTS = "sensor_msgs/msg/JointState";
    private static final String FLAG = "std_msgs/msg/Bool";
    private static final int JOINTS_WAITING = 20; // as several nodes publish some of a robot's joints each

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Gripper;
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("gripper");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return topics.serves(settings.gripper().action(), ACTION);
    }

    @Override
    public boolean isComplete(Wanted wanted, RobotTopics topics, RosSettings settings) {
        boolean hasLift = wanted.part() instanceof Part.Gripper gripper && gripper.hasLift();
        return isThere(wanted, topics, settings)
                && (!hasLift || topics.serves(settings.gripper().liftAction(), ACTION));
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        var part = (Part.Gripper) wanted.part();
        GripperSettings settings = context.settings().gripper();
        var paddles = new GripperJoint(
                client(settings.action(), context),
                context,
                settings.open().orElse(part.opening()),
                settings.closed(),
                settings.effort());
        boolean hasLift = part.hasLift() && context.topics().serves(settings.liftAction(), ACTION);
        Optional<GripperJoint> lift = hasLift
                ? Optional.of(new GripperJoint(
                        client(settings.liftAction(), context), context, 0, part.height(), settings.effort()))
                : Optional.empty();
        String name = context.topics().namespace() + "/" + settings.action();
        var gripper = new RosGripper(info, name, paddles, lift, context);
        var subscriptions = new ArrayList<Subscribed>();
        for (GripperFlag flag : GripperFlag.values()) {
            subscriptions.add(flag(info.name(), flag, gripper, context));
        }
        subscriptions.add(context.link()
                .subscribe(
                        context.topics().ownOrShared("joint_states", JOINTS),
                        Profile.SENSOR_DATA,
                        context.inbox(JOINTS, JOINTS_WAITING, gripper::take)));
        return new RosDevice(gripper, gripper::look, () -> {
            gripper.end();
            subscriptions.forEach(Subscribed::close);
        });
    }

    private static ActionClient client(String action, RosContext context) {
        String name = context.topics().namespace() + "/" + action;
        return context.action(name, ACTION);
    }

    private static Subscribed flag(String gripper, GripperFlag flag, RosGripper device, RosContext context) {
        RosTopic topic = new RosTopic("%s/%s/%s".formatted(context.topics().namespace(), gripper, flag.topic()), FLAG);
        return context.link()
                .subscribe(
                        topic,
                        context.reliable(topic),
                        context.inbox(FLAG, 1, (RosMessage message) -> device.take(flag, message)));
    }
}
