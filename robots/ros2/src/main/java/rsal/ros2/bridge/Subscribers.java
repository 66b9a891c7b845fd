package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Set;
import java.util.stream.Collectors;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;

/// Which topics others subscribe to, as known half a second ago at most: for messages so large that they are made only
/// when somebody subscribes.
final class Subscribers {
    private static final Duration LOOK = Duration.ofMillis(500);

    private final RosLink link;
    private final InstantSource clock;
    private Instant looked = Instant.MIN;
    private Set<RosTopic> heard = Set.of();

    Subscribers(RosLink link, InstantSource clock) {
        this.link = link;
        this.clock = clock;
    }

    boolean isHeard(RosTopic topic) {
        Instant now = clock.instant();
        if (!looked.plus(LOOK).isAfter(now)) {
            looked = now;
            heard = link.endpoints().stream()
                    .filter(each -> !each.isPublisher())
                    .map(RosEndpoint::topic)
                    .collect(Collectors.toUnmodifiableSet());
        }
        return heard.contains(topic);
    }
}
