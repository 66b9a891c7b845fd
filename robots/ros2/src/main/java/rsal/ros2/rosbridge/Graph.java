package rsal.ros2.rosbridge;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosTopic;

/// What the nodes behind a server publish, subscribe to and serve, as `rosapi` told it last.
///
/// @param publishers how many nodes publish a topic
/// @param subscribed topics that nodes subscribe to
/// @param services names of those that are served
/// @param actions types of those that are served, by name; empty where nobody knows it
record Graph(
        Map<RosTopic, Integer> publishers,
        Set<RosTopic> subscribed,
        Set<String> services,
        Map<String, String> actions) {
    static final Graph EMPTY = new Graph(Map.of(), Set.of(), Set.of(), Map.of());

    Graph {
        publishers = Map.copyOf(publishers);
        subscribed = Set.copyOf(subscribed);
        services = Set.copyOf(services);
        actions = Map.copyOf(actions);
    }

    /// How many publish a topic.
    int publishers(RosTopic topic) {
        return publishers.getOrDefault(topic, 0);
    }

    /// All of them, in the order of their names. Of quality of service nothing is known: the server matches it.
    List<RosEndpoint> endpoints() {
        var all = new ArrayList<RosEndpoint>();
        publishers.keySet().forEach(topic -> all.add(endpoint(topic, true)));
        subscribed.forEach(topic -> all.add(endpoint(topic, false)));
        actions.forEach((name, type) -> {
            if (!type.isEmpty()) {
                all.add(endpoint(BridgedActions.feedback(name, type), true));
            }
        });
        all.sort(java.util.Comparator.comparing(
                each -> each.topic().name() + each.topic().type() + each.isPublisher()));
        return List.copyOf(all);
    }

    private static RosEndpoint endpoint(RosTopic topic, boolean isPublisher) {
        return new RosEndpoint(topic, isPublisher, Profile.DEFAULT, Optional.empty());
    }
}
