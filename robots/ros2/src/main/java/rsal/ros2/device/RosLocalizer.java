package rsal.ros2.device;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;
import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.OdometryMessage;
import rsal.ros2.message.RosMessages;

/// A robot's own localizer, such as Nav2's `amcl`: a pose now and then (`amcl_pose`), and where odometry begins on the
/// map (TF from `map` to `odom`). In between, estimates go with the odometry.
final class RosLocalizer extends RosSensor<PoseEstimate> implements Localizer {
    private static final int REMEMBERED = 100; // odometry, to know where the robot was when it was localized
    private static final double SURE = 0.5; // m, rad: with deviations of less a robot is localized
    private static final Covariance2d UNKNOWN = Covariance2d.ofDeviations(0.1, 0.1, 0.05); // where only TF tells

    private final Publication initialPose;
    private final Frames frames;
    private final RobotClock clock;
    private final Deque<Driven> driven = new ArrayDeque<>();
    private final RosMessages messages = new RosMessages();
    private @Nullable Covariance2d covariance; // the newest
    private @Nullable Pose2d mapFromOdom; // by poses, where TF does not tell

    /// Where odometry had the robot.
    private record Driven(long stamp, Pose2d odomFromBase) {}

    RosLocalizer(DeviceInfo info, String topic, Publication initialPose, Frames frames, RobotClock clock) {
        super(info, "map", topic);
        this.initialPose = initialPose;
        this.frames = frames;
        this.clock = clock;
    }

    void take(OdometryMessage odometry) {
        driven.addLast(new Driven(odometry.stamp(), odometry.odomFromBase()));
        if (driven.size() > REMEMBERED) {
            driven.removeFirst();
        }
        Optional<Pose2d> from = frames.mapFromOdom().or(() -> Optional.ofNullable(mapFromOdom));
        from.filter(Pose2d::isFinite).ifPresent(origin -> {
            heard(frames.now());
            tell(clock.time(odometry.stamp()), estimate(origin.compose(odometry.odomFromBase())));
        });
    }

    private PoseEstimate estimate(Pose2d mapFromBase) {
        Covariance2d spread = covariance == null ? UNKNOWN : covariance;
        boolean sure = spread.positionDeviation() < SURE && Math.sqrt(Math.max(0, spread.thetaTheta())) < SURE;
        return new PoseEstimate(
                mapFromBase,
                spread,
                List.of(new Hypothesis(1, mapFromBase, spread)),
                sure ? 1 : 0,
                sure ? Quality.LOCALIZED : Quality.LOST);
    }

    /// @param message `geometry_msgs/PoseWithCovarianceStamped`
    void take(RosMessage message) {
        RosMessages.estimate(message).ifPresent(told -> {
            covariance = told.covariance();
            mapFromOdom = told.mapFromBase()
                    .compose(odomFromBase(RosMessages.stamp(message.message("header")))
                            .inverse());
        });
    }

    /// Where odometry had the robot at a time, or nearest to it.
    private Pose2d odomFromBase(long stamp) {
        return driven.stream()
                .min(Comparator.comparingLong(each -> Math.abs(each.stamp - stamp)))
                .map(Driven::odomFromBase)
                .orElse(Pose2d.ORIGIN);
    }

    /// Publishes it as `initialpose`, as RViz does.
    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        long stamp = clock.stamp();
        initialPose.publish(stamp, messages.pose(Instant.ofEpochSecond(0, stamp), belief, "map"));
        return CompletableFuture.completedFuture(null);
    }
}
