package rsal.ros2.device;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;

/// Makes bumpers of topics of the type `std_msgs/Bool`: those that are set, or `bumper_0`, `bumper_1`, … by the
/// device's name. Otherwise of the hazards of an iRobot Create 3, which has one topic for all.
final class BumperMaker implements RosParts.Maker {
    private static final String FLAG = "std_msgs/msg/Bool";
    private static final String HAZARDS = "irobot_create_msgs/msg/HazardDetectionVector";
    private static final int WAITING = 20; // messages: a short press is two of them

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Bumper bumper && !bumper.pads().isEmpty();
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("bumper", "bumpers");
    }

    /// One for each of its pads.
    private static List<RosTopic> topics(String device, Part part, RobotTopics topics, RosSettings settings) {
        int count = ((Part.Bumper) part).pads().size();
        List<String> names = settings.bumperTopics().isEmpty()
                ? IntStream.range(0, count)
                        .mapToObj(i -> "%s_%d".formatted(device, i))
                        .toList()
                : settings.bumperTopics();
        return names.stream()
                .limit(count)
                .map(name -> new RosTopic(topics.namespace() + "/" + name, FLAG))
                .toList();
    }

    private static boolean hasFlags(Wanted wanted, RobotTopics topics, RosSettings settings) {
        List<RosTopic> all = topics(wanted.name(), wanted.part(), topics, settings);
        return all.size() == ((Part.Bumper) wanted.part()).pads().size()
                && all.stream().allMatch(topics::isPublished);
    }

    /// None where others are set, which may come later.
    private static List<RosTopic> hazards(RobotTopics topics, RosSettings settings) {
        return settings.bumperTopics().isEmpty() ? topics.published(HAZARDS, "hazard_detection") : List.of();
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return hasFlags(wanted, topics, settings) || !hazards(topics, settings).isEmpty();
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        var bumper = new RosBumper(info, (Part.Bumper) wanted.part(), context.frames());
        if (!hasFlags(wanted, context.topics(), context.settings())) {
            RosTopic topic = hazards(context.topics(), context.settings()).getFirst();
            Subscribed hazards = context.link()
                    .subscribe(
                            topic,
                            context.topics().profile(topic),
                            context.inbox(HAZARDS, WAITING, bumper::takeHazards));
            return device(bumper, List.of(topic), List.of(hazards));
        }
        List<RosTopic> all = topics(info.name(), wanted.part(), context.topics(), context.settings());
        var subscriptions = new ArrayList<Subscribed>();
        for (RosTopic topic : all) {
            int number = subscriptions.size();
            subscriptions.add(context.link()
                    .subscribe(
                            topic,
                            context.reliable(topic),
                            context.inbox(FLAG, WAITING, (RosMessage message) -> bumper.take(number, message))));
        }
        return device(bumper, all, subscriptions);
    }

    private static RosDevice device(RosBumper bumper, List<RosTopic> topics, List<Subscribed> subscriptions) {
        return new RosDevice(
                bumper,
                now -> bumper.look(
                        now,
                        IntStream.range(0, topics.size())
                                .filter(i -> subscriptions.get(i).publishers() == 0)
                                .mapToObj(i -> topics.get(i).name())
                                .toList()),
                () -> subscriptions.forEach(Subscribed::close));
    }
}
