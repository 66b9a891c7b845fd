package rsal.ros2.bridge;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import rsal.ros2.link.RosEndpoint;

/// Warns once of each topic that another program of the domain publishes, too, such as a second bridge: then others get
/// the messages of both, and their velocities drive robots of both.
final class OtherPublishers {
    private static final Logger LOG = System.getLogger(OtherPublishers.class.getName());

    private final Set<String> known = new TreeSet<>();

    /// @param own topics that the bridge publishes (`/hunter_1/odom`)
    /// @param others of other programs
    /// @return own topics that somebody else publishes for the first time
    List<String> look(Collection<String> own, List<RosEndpoint> others) {
        List<String> found = others.stream()
                .filter(RosEndpoint::isPublisher)
                .map(each -> each.topic().name())
                .filter(own::contains)
                .distinct()
                .filter(known::add)
                .toList();
        if (!found.isEmpty()) {
            LOG.log(
                    Level.WARNING,
                    () ->
                            "Another program of this domain also publishes %s. Its robots get the same velocities. Choose another ROS_DOMAIN_ID for one of them."
                                    .formatted(String.join(", ", found)));
        }
        return found;
    }
}
