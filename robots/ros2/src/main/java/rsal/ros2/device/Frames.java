package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTree;
import rsal.ros2.message.OdometryMessage;

/// Where a robot's frames are, as it publishes them (TF), and what its odometry calls them.
final class Frames {
    private static final String MAP = "map"; // REP 105

    private final FrameTree tree = new FrameTree();
    private final InstantSource clock;
    private String odom = "odom";
    private String base = "base_link";
    private Instant odomTold = Instant.MAX; // when `/tf` had it last

    Frames(InstantSource clock) {
        this.clock = clock;
    }

    /// @param transforms of `/tf`
    void add(RosMessage transforms) {
        tree.add(transforms);
        boolean hasOdom = transforms.messages("transforms").stream()
                .anyMatch(each -> FrameTree.named(each.text("child_frame_id")).equals(FrameTree.named(odom)));
        if (hasOdom) {
            odomTold = clock.instant();
        }
    }

    /// @param transforms of `/tf_static`
    void addFixed(RosMessage transforms) {
        tree.add(transforms);
    }

    /// Learns what frames are called.
    void add(OdometryMessage odometry) {
        odom = odometry.frame();
        base = odometry.childFrame();
    }

    String odom() {
        return odom;
    }

    String base() {
        return base;
    }

    /// Where something on the robot is.
    Optional<FrameTransform> fromBase(String frame) {
        return tree.find(base, frame);
    }

    /// Where a localizer has the origin of odometry; empty as long as nobody says so.
    Optional<Pose2d> mapFromOdom() {
        return tree.find(MAP, odom).map(FrameTransform::planar);
    }

    /// How long no localizer has said where odometry begins; 0 where none ever did, or that is fixed.
    Duration sinceMapFromOdom(Instant now) {
        return odomTold.isBefore(now) ? Duration.between(odomTold, now) : Duration.ZERO;
    }

    Instant now() {
        return clock.instant();
    }
}
