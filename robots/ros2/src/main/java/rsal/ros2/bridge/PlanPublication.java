package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import rsal.data.Path2d;
import rsal.device.DriveBase;
import rsal.device.Navigator;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.PathMessage;

/// The way that a navigator means to go, as `nav_msgs/Path`: when it changes, twice a second at most, while somebody
/// subscribes; an empty one at the end.
final class PlanPublication {
    private static final Duration PERIOD = Duration.ofMillis(500);

    private final CdrWriter writer = new CdrWriter();
    private final Navigator navigator;
    private final RobotOutlet outlet;
    private final RosTopic topic;
    private final Publication paths;
    private Path2d reported = Path2d.EMPTY;
    private Instant reportedAt = Instant.MIN;

    private PlanPublication(Navigator navigator, RobotOutlet outlet) {
        this.navigator = navigator;
        this.outlet = outlet;
        String name = outlet.name(navigator, Navigator.class, "plan");
        topic = outlet.topic(name, "nav_msgs/msg/Path");
        paths = outlet.advertise(navigator, name, topic.type(), Profile.DEFAULT);
    }

    /// Looked at with each odometry, as navigators tell no changes.
    static void begin(Navigator navigator, RobotOutlet outlet) {
        outlet.robot().find(DriveBase.class).ifPresent(base -> {
            var publication = new PlanPublication(navigator, outlet);
            outlet.keep(base.subscribe(reading -> publication.look(reading.time())));
        });
    }

    private void look(Instant now) {
        boolean isDue = !reportedAt.plus(PERIOD).isAfter(now);
        if (isDue && outlet.isHeard(topic)) {
            Path2d path = navigator.path();
            if (!path.equals(reported)) {
                reported = path;
                reportedAt = now;
                paths.publish(PathMessage.write(
                                writer.clear(),
                                outlet.stamp(now),
                                outlet.frames().map(),
                                PathMessage.poses(path))
                        .toBytes());
            }
        }
    }
}
