package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.OdometryMessage;
import rsal.ros2.tf.TransformLookup;
import rsal.ros2.tf.TransformLookup.Reason;
import rsal.ros2.transform.TransformFeed;

/// Where a robot's frames are, as TF says, and what its odometry calls them.
final class Frames {
    static final String MAP = "map"; // REP 105

    /// By how much a reading may be newer than the transforms of its frame, which are often sent a bit later [ns]. Nav2
    /// has 0.1 to 0.2 s.
    private static final long TOLERANCE = 200_000_000;

    private final TransformFeed feed;
    private final InstantSource clock;
    private String odom = "odom";
    private String base = "base_link";

    Frames(TransformFeed feed, InstantSource clock) {
        this.feed = feed;
        this.clock = clock;
    }

    /// Learns what frames are called.
    void learn(OdometryMessage odometry) {
        odom = odometry.frame();
        base = odometry.childFrame();
    }

    String odom() {
        return odom;
    }

    String base() {
        return base;
    }

    /// Runs something each time that TF has come.
    void onTransforms(Runnable listener) {
        feed.onTransforms(listener);
    }

    Instant now() {
        return clock.instant();
    }

    /// Where something on the robot was at a time, also if it moves on the robot. What is a bit too new is where it was
    /// last.
    ///
    /// @param stamp of a reading [ns]; 0 for the newest
    TransformLookup fromBase(String frame, long stamp) {
        TransformLookup then = feed.find(base, frame, stamp);
        boolean isNearlyKnown = then instanceof TransformLookup.Failure failure
                && failure.reason() == Reason.FUTURE
                && failure.wanted() - failure.known() <= TOLERANCE;
        return isNearlyKnown ? feed.find(base, frame, 0) : then;
    }

    /// Where a frame was on the map at a time; empty where TF does not say.
    ///
    /// @param stamp [ns]; 0 for the newest
    Optional<Pose2d> fromMap(String frame, long stamp) {
        return feed.find(MAP, frame, stamp).transform().map(FrameTransform::planar);
    }

    /// Whether a localizer says by TF where the odometry began.
    boolean hasMapFromOdom() {
        return feed.find(MAP, odom, 0).isConnected();
    }

    /// Where the odometry began on the map, as the localizer saw it at a time: in between, what it says holds until it
    /// says otherwise. Empty where TF does not say.
    private Optional<Pose2d> mapFromOdom(long stamp) {
        TransformLookup then = feed.find(MAP, odom, stamp);
        TransformLookup best = then.isConnected() && then.transform().isEmpty() ? feed.find(MAP, odom, 0) : then;
        return best.transform().map(FrameTransform::planar);
    }

    /// How long no localizer has said where odometry begins; 0 where none ever did, or that is fixed.
    Duration sinceMapFromOdom() {
        return feed.silence(MAP, odom);
    }

    /// Where the robot was in the frame of its odometry: as TF says, which may know better than wheels alone, or as the
    /// odometry does where TF does not connect the two. Fails where TF has yet to come, or began later.
    TransformLookup odomFromBase(OdometryMessage odometry) {
        TransformLookup then = feed.find(odom, base, odometry.stamp());
        return then.isConnected() ? then : new TransformLookup.Found(FrameTransform.of(odometry.odomFromBase()));
    }

    /// Where the robot was on the map when its odometry was measured; empty where no localizer says so by TF.
    ///
    /// @param odomFromBase at that time
    Optional<Pose2d> mapFromBase(OdometryMessage odometry, FrameTransform odomFromBase) {
        return mapFromOdom(odometry.stamp()).map(origin -> origin.compose(odomFromBase.planar()));
    }
}
