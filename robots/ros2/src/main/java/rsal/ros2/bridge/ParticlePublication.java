package rsal.ros2.bridge;

import java.time.Instant;
import rsal.data.ParticleCloud;
import rsal.data.Stamped;
import rsal.device.Localizer;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.CloudMessage;

/// Particles of a robot's first localizer as `nav2_msgs/ParticleCloud`: with each estimate that has new ones, while
/// somebody subscribes.
final class ParticlePublication {
    private static final String NAME = "particle_cloud";

    private final CdrWriter writer = new CdrWriter();
    private final Localizer localizer;
    private final RobotOutlet outlet;
    private final RosTopic topic;
    private final Publication clouds;
    private Instant reported = Instant.MIN;

    private ParticlePublication(Localizer localizer, RobotOutlet outlet) {
        this.localizer = localizer;
        this.outlet = outlet;
        topic = outlet.topic(NAME, "nav2_msgs/msg/ParticleCloud");
        clouds = outlet.advertise(localizer, NAME, topic.type(), Profile.SENSOR_DATA);
    }

    static void begin(Localizer localizer, RobotOutlet outlet) {
        if (outlet.robot().find(Localizer.class).filter(localizer::equals).isPresent()) {
            var publication = new ParticlePublication(localizer, outlet);
            outlet.keep(localizer.subscribe(_ -> publication.look()));
        }
    }

    private void look() {
        if (outlet.isHeard(topic)) {
            localizer
                    .particles()
                    .filter(cloud -> cloud.time().isAfter(reported))
                    .ifPresent(this::publish);
        }
    }

    private void publish(Stamped<ParticleCloud> cloud) {
        reported = cloud.time();
        clouds.publish(CloudMessage.write(
                        writer.clear(),
                        outlet.stamp(cloud.time()),
                        outlet.frames().map(),
                        cloud.value())
                .toBytes());
    }
}
