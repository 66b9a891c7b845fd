package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Function;
import rsal.data.Covariance2d;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.CloudMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.OdometryMessage;
import rsal.ros2.message.RosMessages;
import rsal.ros2.tf.TransformLookup;
import rsal.ros2.tf.TransformLookup.Reason;

/// A robot's own localizer, such as Nav2's `amcl` or slam_toolbox: a pose now and then (`amcl_pose`), and where the
/// odometry begins on the map (TF from `map` to `odom`). In between, estimates go with the odometry, as long as the
/// localizer is there: TF that stops coming is stale, and where only poses come, somebody must publish them.
///
/// Each estimate is of the time of an odometry message. Where TF says also how the robot moves in `odom`, as a
/// filter of several sensors does, that counts and not the wheels; the estimate then waits for the TF of its
/// time.
final class RosLocalizer extends RosSensor<PoseEstimate> implements Localizer {
    private static final int REMEMBERED = 100; // odometry, to know where the robot was when it was localized
    private static final double SURE = 0.5; // m, rad: with deviations of less a robot is localized
    private static final int MOST_WAITING = 100; // odometry, for TF of its time
    private static final long AGO = 1_000_000_000; // ns; by more than that no message is delayed
    private static final Duration PATIENCE = Duration.ofMillis(500); // amcl tells with each scan
    private static final Covariance2d UNKNOWN = Covariance2d.ofDeviations(0.1, 0.1, 0.05); // where only TF tells

    private final Publication initialPose;
    private final Function<Consumer<RosMessage>, Subscribed> cloudTopic;
    private final Frames frames;
    private final RobotClock clock;
    private final Deque<Driven> driven = new ArrayDeque<>();
    private final Deque<OdometryMessage> waiting = new ArrayDeque<>(); // for TF
    private final RosMessages messages = new RosMessages();
    private Optional<TransformLookup.Failure> late = Optional.empty(); // what the first that waits lacks
    private Instant waitingSince = Instant.MAX;
    private Optional<Outdated> outdated = Optional.empty(); // since odometry was located last
    private long heard; // stamp of the last odometry [ns]
    private Optional<Pose> newest = Optional.empty();
    private Optional<Pose2d> mapFromOdom = Optional.empty(); // by poses, where TF does not tell
    private Optional<Subscribed> clouds = Optional.empty(); // since somebody asked for particles
    private Optional<Stamped<ParticleCloud>> particles = Optional.empty();
    private boolean isThere = true;

    /// Where odometry had the robot.
    private record Driven(long stamp, Pose2d odomFromBase) {}

    /// Odometry that is older than all TF is left out.
    ///
    /// @param why of the newest
    private record Outdated(TransformLookup.Failure why, Instant since) {}

    /// Where the localizer had it.
    private record Pose(long stamp, PoseEstimate estimate) {}

    /// @param cloudTopic subscribes to its particles
    RosLocalizer(
            DeviceInfo info,
            String topic,
            Publication initialPose,
            Function<Consumer<RosMessage>, Subscribed> cloudTopic,
            Frames frames,
            RobotClock clock) {
        super(info, Frames.MAP, "'%s', nor TF from 'map'".formatted(topic));
        this.cloudTopic = cloudTopic;
        this.initialPose = initialPose;
        this.frames = frames;
        this.clock = clock;
        frames.onTransforms(this::settle);
    }

    /// @param odometry which is finite
    void take(OdometryMessage odometry) {
        if (waiting.size() == MOST_WAITING) {
            waiting.removeFirst();
        }
        if (odometry.stamp() < heard - AGO) { // a simulator was reset
            waiting.clear();
            driven.clear();
        }
        heard = odometry.stamp();
        if (waiting.isEmpty()) {
            waitingSince = frames.now();
        }
        waiting.addLast(odometry);
        settle();
    }

    /// Takes all odometry for which TF has come, in order; leaves out what is older than all TF.
    private void settle() {
        late = Optional.empty();
        while (!waiting.isEmpty() && late.isEmpty()) {
            switch (frames.odomFromBase(waiting.getFirst())) {
                case TransformLookup.Found(FrameTransform odomFromBase) -> locate(waiting.removeFirst(), odomFromBase);
                case TransformLookup.Failure old when old.reason() == Reason.PAST -> outdate(old);
                case TransformLookup.Failure missing -> late = Optional.of(missing);
            }
        }
    }

    private void outdate(TransformLookup.Failure old) {
        waiting.removeFirst();
        outdated = Optional.of(new Outdated(old, outdated.map(Outdated::since).orElseGet(frames::now)));
    }

    private void locate(OdometryMessage odometry, FrameTransform odomFromBase) {
        waitingSince = frames.now();
        outdated = Optional.empty();
        driven.addLast(new Driven(odometry.stamp(), odomFromBase.planar()));
        if (driven.size() > REMEMBERED) {
            driven.removeFirst();
        }
        if (mapFromOdom.isEmpty()) {
            join(); // the pose came first
        }
        if (isThere) {
            frames.mapFromBase(odometry, odomFromBase)
                    .or(() -> mapFromOdom.map(origin -> origin.compose(odomFromBase.planar())))
                    .ifPresent(mapFromBase -> publish(clock.time(odometry.stamp()), estimate(mapFromBase)));
        }
    }

    private PoseEstimate estimate(Pose2d mapFromBase) {
        Covariance2d spread = newest.map(pose -> pose.estimate.covariance()).orElse(UNKNOWN);
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
        RosMessage header = message.message("header");
        long stamp = RosMessages.stamp(header);
        RosMessages.estimate(message)
                .map(reported -> onMap(reported, RosMessages.frame(header.text("frame_id")), stamp))
                .ifPresent(reported -> {
                    newest = Optional.of(new Pose(stamp, reported));
                    join();
                });
    }

    /// What a localizer says in a frame of its own, such as `robot1/map`; as it is where TF does not connect that with
    /// the map.
    private PoseEstimate onMap(PoseEstimate reported, String frame, long stamp) {
        return frame.equals(Frames.MAP)
                ? reported
                : frames.fromMap(frame, stamp)
                        .map(origin -> PoseEstimate.of(
                                origin.compose(reported.mapFromBase()),
                                reported.covariance().turned(origin.theta())))
                        .orElse(reported);
    }

    /// Where odometry began, by the newest pose and the odometry of that time, or nearest to it: localizers tell poses
    /// only when the robot moves, so that the odometry nearest to an old pose has hardly changed since.
    private void join() {
        newest.ifPresent(pose -> driven.stream()
                .min(Comparator.comparingLong(each -> Math.abs(each.stamp - pose.stamp)))
                .ifPresent(then ->
                        mapFromOdom = Optional.of(pose.estimate.mapFromBase().compose(then.odomFromBase.inverse()))));
    }

    /// Looks whether the localizer is still there.
    ///
    /// @param publishers how many publish poses
    @Override
    void look(Instant now, int publishers) {
        boolean isSilent = frames.sinceMapFromOdom().compareTo(PATIENCE) > 0;
        isThere = !isSilent && (publishers > 0 || frames.hasMapFromOdom());
        if (!isThere && publishers == 0) {
            super.look(now, publishers);
        } else if (isThere) {
            late.filter(_ -> waitingSince.plus(PATIENCE).isBefore(now))
                    .ifPresent(missing -> health(new Health.Stale(
                            "The odometry on '%s' waits for TF. %s".formatted(frames.odom(), missing.message()))));
            outdated.filter(left -> left.since.plus(PATIENCE).isBefore(now))
                    .ifPresent(left -> health(new Health.Stale(
                            "The odometry on '%s' is older than TF. %s".formatted(frames.odom(), left.why.message()))));
        } else {
            health(new Health.Stale("TF from 'map' to '%s' has not come for more than %.1f s."
                    .formatted(frames.odom(), PATIENCE.toMillis() / 1e3)));
        }
    }

    /// The first call subscribes to them, since clouds are large.
    @Override
    public Optional<Stamped<ParticleCloud>> particles() {
        if (clouds.isEmpty()) {
            clouds = Optional.of(cloudTopic.apply(this::takeCloud));
        }
        return clouds.filter(cloud -> cloud.publishers() > 0).flatMap(_ -> particles);
    }

    /// @param message `nav2_msgs/ParticleCloud`
    private void takeCloud(RosMessage message) {
        RosMessage header = message.message("header");
        if (RosMessages.frame(header.text("frame_id")).equals(Frames.MAP)) {
            CloudMessage.of(message)
                    .ifPresent(cloud -> particles =
                            Optional.of(new Stamped<>(clock.time(RosMessages.stamp(header)), Frames.MAP, cloud)));
        }
    }

    /// For good.
    void end() {
        clouds.ifPresent(Subscribed::close);
        initialPose.close();
    }

    /// Publishes it as `initialpose`, as RViz does.
    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        initialPose.publish(messages.pose(Instant.ofEpochSecond(0, clock.stamp()), belief, Frames.MAP));
        return CompletableFuture.completedFuture(null);
    }
}
