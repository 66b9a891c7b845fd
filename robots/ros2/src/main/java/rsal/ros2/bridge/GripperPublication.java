package rsal.ros2.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import rsal.data.GripperState;
import rsal.data.Stamped;
import rsal.device.Gripper;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.RosMessages;

/// How a gripper is: its joints in `sensor_msgs/JointState`, the gap between its paddles [m] and how far its lift is up
/// [m]; what ROS has no type for as `std_msgs/Bool`, also for late subscribers, when it changes.
final class GripperPublication {
    private static final double CLOSED = 1; // how far, of paddles that can't measure it

    private final CdrWriter writer = new CdrWriter();
    private final Part.Gripper part;
    private final RobotOutlet outlet;
    private final GripperNames names;
    private final List<Flag> flags = new ArrayList<>();
    private final Publication joints;

    /// Something that is so or not.
    private static final class Flag {
        private final Predicate<GripperState> value;
        private final Publication publication;
        private String reported = "";

        Flag(Predicate<GripperState> value, Publication publication) {
            this.value = value;
            this.publication = publication;
        }

        void publish(GripperState state, CdrWriter writer) {
            boolean now = value.test(state);
            if (!reported.equals(Boolean.toString(now))) {
                reported = Boolean.toString(now);
                publication.publish(writer.clear().bool(now).toBytes());
            }
        }
    }

    private GripperPublication(Gripper gripper, Part.Gripper part, RobotOutlet outlet) {
        this.part = part;
        this.outlet = outlet;
        names = GripperNames.of(gripper, outlet);
        flag(gripper, "inner_beam", GripperState::innerBeamBroken, outlet);
        flag(gripper, "outer_beam", GripperState::outerBeamBroken, outlet);
        flag(gripper, "left_contact", GripperState::leftContact, outlet);
        flag(gripper, "right_contact", GripperState::rightContact, outlet);
        flag(gripper, "holding", GripperState::holding, outlet);
        joints = outlet.advertise(gripper, "joint_states", "sensor_msgs/msg/JointState", Profile.DEFAULT);
    }

    private void flag(Gripper gripper, String name, Predicate<GripperState> value, RobotOutlet outlet) {
        String topic = "%s/%s".formatted(names.name(), name);
        flags.add(new Flag(value, outlet.advertise(gripper, topic, "std_msgs/msg/Bool", Profile.LATCHED)));
    }

    /// Sizes are those of the model; without them nothing can be published.
    static void begin(Gripper gripper, RobotOutlet outlet) {
        if (outlet.robot().model().sensors().get(gripper.info().name()) instanceof Part.Gripper part) {
            var publication = new GripperPublication(gripper, part, outlet);
            outlet.keep(gripper.subscribe(publication::publish));
        }
    }

    /// The gap between the paddles [m].
    static double gap(Part.Gripper part, GripperState state) {
        double closed = Double.isNaN(state.closed())
                ? state.paddles() == GripperState.Paddles.OPEN ? 0 : CLOSED
                : state.closed();
        return part.opening() * (1 - closed);
    }

    /// How far the lift is up [m].
    static double height(Part.Gripper part, GripperState state) {
        double raised = Double.isNaN(state.raised()) ? state.lift() == GripperState.Lift.UP ? 1 : 0 : state.raised();
        return part.height() * raised;
    }

    /// Joints come last, as clients take the whole state then.
    private void publish(Stamped<GripperState> reading) {
        GripperState state = reading.value();
        flags.forEach(flag -> flag.publish(state, writer));
        int count = part.hasLift() ? 2 : 1;
        RosMessages.write(writer.clear(), outlet.stamp(reading.time()))
                .text("")
                .int32(count)
                .text(names.paddlesJoint());
        if (part.hasLift()) {
            writer.text(names.liftJoint());
        }
        writer.int32(count).float64(gap(part, state));
        if (part.hasLift()) {
            writer.float64(height(part, state));
        }
        joints.publish(writer.int32(0).int32(0).toBytes()); // neither speeds nor efforts
    }
}
