package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosTopic;

class OtherPublishersTest {
    private static RosEndpoint endpoint(String topic, boolean isPublisher) {
        return new RosEndpoint(
                new RosTopic(topic, "nav_msgs/msg/Odometry"), isPublisher, Profile.DEFAULT, Optional.empty());
    }

    @Test
    void reportsOnceWhatAnotherProgramPublishesToo() {
        var rivals = new OtherPublishers();
        List<String> own = List.of("/r1/odom", "/r2/odom");
        assertThat(rivals.look(own, List.of(endpoint("/r1/odom", false), endpoint("/r3/odom", true))))
                .isEmpty();
        List<RosEndpoint> both = List.of(endpoint("/r1/odom", true), endpoint("/r1/odom", true));
        assertThat(rivals.look(own, both)).containsExactly("/r1/odom");
        assertThat(rivals.look(own, both)).isEmpty();
    }
}
