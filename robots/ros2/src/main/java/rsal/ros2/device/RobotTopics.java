package rsal.ros2.device;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// What is published and subscribed to in the namespace of a robot.
///
/// @param namespace `/robot1`; empty for topics without any
/// @param all of the network, of which those of its namespace and those without any are kept
public record RobotTopics(String namespace, List<RosEndpoint> all) {
    public RobotTopics {
        String own = namespace + "/";
        all = all.stream()
                .filter(each -> each.topic().name().startsWith(own)
                        || each.topic().name().lastIndexOf('/') == 0)
                .toList();
    }

    private boolean isOurs(RosTopic topic) {
        return topic.name().startsWith(namespace + "/")
                && (!namespace.isEmpty() || topic.name().lastIndexOf('/') == 0);
    }

    /// Topics of a type that somebody publishes.
    ///
    /// @param preferred what the first one is called, if it is there; the others by their names, `sonar_2` before
    ///     `sonar_10`
    List<RosTopic> published(String type, String preferred) {
        return all.stream()
                .filter(RosEndpoint::isPublisher)
                .map(RosEndpoint::topic)
                .filter(topic -> topic.type().equals(type) && isOurs(topic))
                .distinct()
                .sorted(Comparator.<RosTopic>comparingInt(
                                topic -> topic.name().equals(namespace + "/" + preferred) ? 0 : 1)
                        .thenComparingInt(topic -> topic.name().length())
                        .thenComparing(RosTopic::name))
                .toList();
    }

    /// A topic of a type that somebody publishes: that of a device's name if there is one, else the usual one, else the
    /// first one.
    ///
    /// @param type that somebody publishes
    RosTopic named(String type, String device, String usual) {
        List<RosTopic> own = published(type, device);
        var wanted = new RosTopic(namespace + "/" + device, type);
        return own.contains(wanted) ? wanted : published(type, usual).getFirst();
    }

    /// A topic of that name that somebody subscribes to, of the first of these types that there is.
    Optional<RosTopic> subscribed(String name, List<String> types) {
        return types.stream()
                .map(type -> new RosTopic(namespace + "/" + name, type))
                .filter(topic -> all.stream()
                        .anyMatch(each -> !each.isPublisher() && each.topic().equals(topic)))
                .findFirst();
    }

    /// The robot's own topic where somebody publishes it, the one of all robots otherwise.
    RosTopic ownOrShared(String name, String type) {
        var own = new RosTopic(namespace + "/" + name, type);
        return isPublished(own) ? own : new RosTopic("/" + name, type);
    }

    /// Whether a program offers an action: it publishes the feedback.
    ///
    /// @param name in the robot's namespace: `navigate_to_pose`
    /// @param type `nav2_msgs/action/NavigateToPose`
    boolean serves(String name, String type) {
        return isPublished(
                new RosTopic("%s/%s/_action/feedback".formatted(namespace, name), type + "_FeedbackMessage"));
    }

    boolean isPublished(RosTopic topic) {
        return all.stream().anyMatch(each -> each.isPublisher() && each.topic().equals(topic));
    }

    /// As its publishers offer it, so that a subscription fits all of them; [Profile#SENSOR_DATA] where there is none.
    Profile profile(RosTopic topic) {
        return all.stream()
                .filter(each -> each.isPublisher() && each.topic().equals(topic))
                .map(RosEndpoint::profile)
                .min(Comparator.naturalOrder())
                .orElse(Profile.SENSOR_DATA);
    }

    /// As [#profile], so that nothing gets lost.
    Profile reliable(RosTopic topic) {
        Profile offered = profile(topic);
        return offered == Profile.SENSOR_DATA ? Profile.DEFAULT : offered;
    }

    /// Which distribution's types its programs use, by the hashes that they announce. Humble's announce none.
    ///
    /// @param usual where the hashes fit it as well as any other
    public Distribution distribution(Distribution usual) {
        List<RosEndpoint> ours = all.stream()
                .filter(each -> each.topic().name().startsWith(namespace + "/"))
                .toList();
        if (ours.stream().allMatch(each -> each.typeHash().isEmpty())) {
            return Distribution.HUMBLE;
        }
        Comparator<Distribution> fit = Comparator.comparingLong(each -> fitting(ours, each));
        return Arrays.stream(Distribution.values())
                .max(fit.thenComparing(each -> each.equals(usual)))
                .orElseThrow();
    }

    private static long fitting(List<RosEndpoint> endpoints, Distribution distribution) {
        TypeLibrary types = TypeLibrary.of(distribution);
        return endpoints.stream()
                .filter(each -> each.typeHash().isPresent()
                        && each.typeHash().equals(types.hash(each.topic().type())))
                .count();
    }

    /// For people: what there is.
    public String words() {
        String here = all.stream()
                .map(RosEndpoint::topic)
                .filter(this::isOurs)
                .map(topic -> "'%s' (%s)".formatted(topic.name(), topic.type()))
                .distinct()
                .sorted()
                .collect(Collectors.joining(", "));
        return here.isEmpty() ? "There are no topics in its namespace." : "Its namespace has %s.".formatted(here);
    }
}
