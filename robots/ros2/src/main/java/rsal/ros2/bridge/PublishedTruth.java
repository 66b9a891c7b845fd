package rsal.ros2.bridge;

import java.time.Duration;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.simulation.TruthTracker;
import rsal.ros2.urdf.UrdfWriter;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Where a simulated robot really is, for those who evaluate: odometry without errors, in the frame `map`. No
/// frame of TF comes of it, as `base_link` has a parent already.
final class PublishedTruth {
    private static final Duration PERIOD = Duration.ofMillis(50);

    private final String robot;
    private final TruthTracker truth;
    private final Scheduler scheduler;
    private final RosMessages messages = new RosMessages();
    private final Publication odometry;
    private final Task publishing;

    /// @param robot its id
    /// @param link of its node
    PublishedTruth(String robot, TruthTracker truth, RosLink link, String namespace, Scheduler scheduler) {
        this.robot = robot;
        this.truth = truth;
        this.scheduler = scheduler;
        odometry = link.advertise(new RosTopic(namespace + "/ground_truth", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        publishing = scheduler.every(PERIOD, Phase.OBSERVE, this::publish);
    }

    private void publish() {
        truth.pose(robot).ifPresent(pose -> {
            var value = new Odometry(pose, ofBase(truth.velocity(robot), pose), false);
            odometry.publish(messages.odometry(scheduler.instant(), value, "map", UrdfWriter.BASE));
        });
    }

    /// In the robot's own axes.
    private static Twist2d ofBase(Twist2d velocity, Pose2d pose) {
        double cos = Math.cos(pose.theta());
        double sin = Math.sin(pose.theta());
        return new Twist2d(
                cos * velocity.vx() + sin * velocity.vy(), cos * velocity.vy() - sin * velocity.vx(), velocity.omega());
    }

    void close() {
        publishing.cancel();
        odometry.close();
    }
}
