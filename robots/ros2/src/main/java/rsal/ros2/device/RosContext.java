package rsal.ros2.device;

import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import rsal.ros2.action.ActionClient;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;

/// What devices of a robot are made with.
///
/// @param topics of the robot
/// @param types of its distribution
/// @param base which switches the robot's motors
/// @param random for ids of goals, which nobody else may have
record RosContext(
        RobotTopics topics,
        RosLink link,
        TypeLibrary types,
        Scheduler scheduler,
        Frames frames,
        RobotClock clock,
        RosBase base,
        RosSettings settings,
        RandomGenerator random) {
    Inbox<RosMessage> inbox(String type, int capacity, Consumer<RosMessage> receiver) {
        MessageCodec codec = MessageCodec.of(types.get(type), types);
        return new Inbox<>(capacity, codec::read, scheduler, receiver);
    }

    /// A client of an action.
    ///
    /// @param name with its namespace
    ActionClient action(String name, String type) {
        return new ActionClient(link, types, name, type, scheduler, random);
    }

    /// The newest messages of a sensor.
    Subscribed newest(RosTopic topic, Consumer<RosMessage> receiver) {
        return link.subscribe(topic, Profile.SENSOR_DATA, inbox(topic.type(), 1, receiver));
    }

    /// As it is offered, and so that nothing gets lost; latched where nobody offers it yet.
    Profile reliable(RosTopic topic) {
        return topics.isPublished(topic) ? topics.reliable(topic) : Profile.LATCHED;
    }
}
