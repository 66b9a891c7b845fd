package rsal.navigation.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.device.SensorCore;

/// A localizer that takes odometry at its word: the robot is where it started, moved as its wheels say. Its
/// uncertainty is that of its start and does not grow. Silent until it is told where the robot starts, and
/// while odometry is not a number. It does not notice when somebody resets odometry on the way.
final class OdometryLocalizer extends SensorCore<PoseEstimate> implements Localizer {
    private final OccupancyGrid map;
    private final List<CompletableFuture<Void>> followers = new ArrayList<>();
    private @Nullable PoseEstimate start; // to begin from with the next odometry
    private @Nullable Pose2d mapFromOdom;
    private @Nullable Odometry newest;
    private Covariance2d covariance = Covariance2d.ofDeviations(0, 0, 0);

    /// @param map in whose frame it starts
    OdometryLocalizer(DeviceInfo info, OccupancyGrid map, Optional<PoseEstimate> start) {
        super(info);
        this.map = map;
        this.start = start.orElse(null);
    }

    void follow(DriveBase base) {
        newest = base.latest()
                .map(Stamped::value)
                .filter(OdometryLocalizer::isNumber)
                .orElse(null);
        begin();
        base.subscribe(this::onOdometry);
        base.onHealth(this::health);
    }

    @Override
    public Optional<OccupancyGrid> givenMap() {
        return Optional.of(map);
    }

    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        if (!belief.mapFromBase().isFinite()) {
            throw new IllegalArgumentException("A robot can't be at '%s'.".formatted(belief.mapFromBase()));
        }
        start = belief;
        begin(); // where odometry is now, since the robot may be on its way before the next reading
        var follower = new CompletableFuture<Void>();
        followers.add(follower);
        return follower.minimalCompletionStage();
    }

    private void begin() {
        if (start != null && newest != null) {
            mapFromOdom = start.mapFromBase().compose(newest.odomFromBase().inverse());
            covariance = start.covariance();
            start = null;
        }
    }

    private static boolean isNumber(Odometry odometry) {
        return odometry.odomFromBase().isFinite();
    }

    private void onOdometry(Stamped<Odometry> odometry) {
        if (!isNumber(odometry.value())) {
            return;
        }
        newest = odometry.value();
        begin();
        if (mapFromOdom == null) {
            return;
        }
        Pose2d mapFromBase = mapFromOdom.compose(newest.odomFromBase());
        deliver(new Stamped<>(odometry.time(), "map", PoseEstimate.of(mapFromBase, covariance)));
        var answered = List.copyOf(followers);
        followers.clear();
        answered.forEach(follower -> follower.complete(null));
    }
}
