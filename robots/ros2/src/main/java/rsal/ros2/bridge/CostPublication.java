package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.device.DriveBase;
import rsal.device.Navigator;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;

/// What places cost a robot's first navigator, as `nav_msgs/OccupancyGrid`, as Nav2's global costmap: when it changes,
/// once a second at most, while somebody subscribes.
final class CostPublication {
    private static final String NAME = "global_costmap/costmap";
    private static final Duration PERIOD = Duration.ofSeconds(1);

    private final RosMessages messages;
    private final Navigator navigator;
    private final RobotOutlet outlet;
    private final RosTopic topic;
    private final Publication grids;
    private Optional<OccupancyGrid> reported = Optional.empty();
    private Instant looked = Instant.MIN;

    private CostPublication(Navigator navigator, RobotOutlet outlet) {
        this.navigator = navigator;
        this.outlet = outlet;
        messages = new RosMessages(outlet::stamp);
        topic = outlet.topic(NAME, "nav_msgs/msg/OccupancyGrid");
        grids = outlet.advertise(navigator, NAME, topic.type(), Profile.LATCHED);
    }

    /// Looked at with odometry, as navigators tell no changes.
    static void begin(Navigator navigator, RobotOutlet outlet) {
        boolean isFirst =
                outlet.robot().find(Navigator.class).filter(navigator::equals).isPresent();
        outlet.robot().find(DriveBase.class).filter(_ -> isFirst).ifPresent(base -> {
            var publication = new CostPublication(navigator, outlet);
            outlet.keep(base.subscribe(reading -> publication.look(reading.time())));
        });
    }

    private void look(Instant now) {
        if (!looked.plus(PERIOD).isAfter(now) && outlet.isHeard(topic)) {
            looked = now;
            navigator.costMap().filter(this::isNew).ifPresent(costs -> {
                reported = Optional.of(costs);
                grids.publish(messages.map(now, costs, outlet.frames().map()));
            });
        }
    }

    private boolean isNew(OccupancyGrid costs) {
        return reported.filter(before -> before.width() == costs.width()
                        && before.originX() == costs.originX()
                        && before.originY() == costs.originY()
                        && Arrays.equals(before.cells(), costs.cells()))
                .isEmpty();
    }
}
