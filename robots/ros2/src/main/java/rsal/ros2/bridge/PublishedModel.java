package rsal.ros2.bridge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.ActuatorState;
import rsal.data.Odometry;
import rsal.data.Stamped;
import rsal.device.Actuator;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.Wheels;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.ros2.simulation.PublishedTime;
import rsal.ros2.urdf.UrdfWriter;

/// What a robot is like: its description (URDF), and where its joints are, if it has any.
final class PublishedModel {
    private final Robot robot;
    private final RosMessages messages;
    private final Map<String, ActuatorState> joints = new LinkedHashMap<>(); // by name
    private final List<Subscription> subscriptions = new ArrayList<>();
    private Optional<WheelJoints> wheels = Optional.empty(); // since the first odometry

    /// Publishes them until it is closed, and the link.
    ///
    /// @param link of the robot's node
    /// @param time that messages have
    PublishedModel(Robot robot, RosLink link, String namespace, PublishedTime time) {
        this.robot = robot;
        messages = new RosMessages(time::stamp);
        link.advertise(new RosTopic(namespace + "/robot_description", "std_msgs/msg/String"), Profile.LATCHED)
                .publish(messages.text(UrdfWriter.urdf(namespace.substring(1), robot.model())));
        var actuators = new LinkedHashMap<Actuator, Part.Actuator>();
        for (Device device : robot.devices()) {
            if (device instanceof Actuator actuator
                    && robot.model().sensors().get(device.info().name()) instanceof Part.Actuator part) {
                actuators.put(actuator, part);
            }
        }
        Optional<Wheels> its = UrdfWriter.wheels(robot.model());
        Optional<DriveBase> base = robot.find(DriveBase.class).filter(_ -> its.isPresent());
        if (!actuators.isEmpty() || base.isPresent()) {
            Publication states = link.advertise(
                    new RosTopic(namespace + "/joint_states", "sensor_msgs/msg/JointState"), Profile.DEFAULT);
            Publication frames =
                    link.advertise(new RosTopic(namespace + "/tf", "tf2_msgs/msg/TFMessage"), Profile.DEFAULT);
            actuators.forEach((actuator, part) -> subscriptions.add(
                    actuator.subscribe(reading -> publish(actuator.info().name(), part, reading, states, frames))));
            base.ifPresent(driven -> subscriptions.add(
                    driven.subscribe(reading -> publish(its.orElseThrow(), reading, states, frames))));
        }
    }

    private void publish(Wheels its, Stamped<Odometry> reading, Publication states, Publication frames) {
        wheels = wheels.or(() -> Optional.of(new WheelJoints(robot.model().drive(), its, reading)));
        Map<String, ActuatorState> turned = wheels.orElseThrow().turn(reading);
        joints.putAll(turned);
        states.publish(messages.joints(reading.time(), joints));
        var transforms = new ArrayList<Transform>();
        turned.forEach((joint, state) -> transforms.add(new Transform(
                reading.time(),
                UrdfWriter.BASE,
                UrdfWriter.link(joint),
                UrdfWriter.wheel(its, joint, state.position()))));
        frames.publish(messages.transforms(transforms));
    }

    private void publish(
            String name, Part.Actuator part, Stamped<ActuatorState> reading, Publication states, Publication frames) {
        joints.put(name, reading.value());
        states.publish(messages.joints(reading.time(), joints));
        frames.publish(messages.transforms(List.of(new Transform(
                reading.time(),
                UrdfWriter.carrier(robot.model(), name),
                name,
                UrdfWriter.moved(robot.model(), name, part, reading.value().position())))));
    }

    void close() {
        subscriptions.forEach(Subscription::cancel);
    }
}
