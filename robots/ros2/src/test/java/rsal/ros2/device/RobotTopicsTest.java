package rsal.ros2.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// Which distribution a robot's topics are of.
class RobotTopicsTest {
    private static final RosTopic ODOMETRY = new RosTopic("/r1/odom", "nav_msgs/msg/Odometry");
    private static final RosTopic FEEDBACK =
            new RosTopic("/r1/navigate_to_pose/_action/feedback", "nav2_msgs/action/NavigateToPose_FeedbackMessage");

    private static RosEndpoint endpoint(RosTopic topic, Distribution distribution) {
        Optional<String> hash = distribution == Distribution.HUMBLE
                ? Optional.empty()
                : TypeLibrary.of(distribution).hash(topic.type());
        return new RosEndpoint(topic, true, Profile.DEFAULT, hash);
    }

    @ParameterizedTest
    @EnumSource
    void whatDiffersShowsTheDistribution(Distribution distribution) {
        List<RosEndpoint> all = new ArrayList<>();
        for (RosTopic topic : List.of(ODOMETRY, FEEDBACK)) {
            all.add(endpoint(topic, distribution));
        }
        all.add(endpoint(new RosTopic("/r2/odom", ODOMETRY.type()), Distribution.KILTED)); // another robot
        Distribution reported = new RobotTopics("/r1", all).distribution(Distribution.JAZZY);
        boolean isSameFeedback = endpoint(FEEDBACK, distribution).equals(endpoint(FEEDBACK, Distribution.JAZZY));
        assertThat(reported).isEqualTo(isSameFeedback ? Distribution.JAZZY : distribution);
    }

    @Test
    void whatDoesNotDifferIsTheUsualOne() {
        var topics = new RobotTopics("/r1", List.of(endpoint(ODOMETRY, Distribution.LYRICAL)));
        assertThat(topics.distribution(Distribution.JAZZY)).isEqualTo(Distribution.JAZZY);
        assertThat(topics.distribution(Distribution.KILTED)).isEqualTo(Distribution.KILTED);
    }
}
