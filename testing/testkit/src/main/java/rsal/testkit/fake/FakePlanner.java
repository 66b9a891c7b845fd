package rsal.testkit.fake;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// Knows only straight ways.
public final class FakePlanner extends DeviceCore implements Planner {
    private final OccupancyGrid map;
    private final Scheduler scheduler;
    private @Nullable Stamped<Asked> latest;

    private FakePlanner(DeviceInfo info, OccupancyGrid map, Scheduler scheduler) {
        super(info);
        this.map = map;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
        var result = new CompletableFuture<Result>();
        Instant asked = scheduler.instant();
        scheduler.execute(() -> {
            Result straight = straight(map, mapFromStart, mapFromGoal);
            latest = new Stamped<>(asked, "map", Asked.of(mapFromStart, mapFromGoal, straight));
            result.complete(straight);
        });
        return result;
    }

    @Override
    public Optional<Stamped<Asked>> latest() {
        return Optional.ofNullable(latest);
    }

    static Result straight(OccupancyGrid map, Pose2d mapFromStart, Pose2d mapFromGoal) {
        if (!map.isFree(mapFromGoal.x(), mapFromGoal.y())) {
            return new Result.NoPath("The goal '%s' is not free.".formatted(mapFromGoal));
        }
        double length = mapFromStart.distanceTo(mapFromGoal);
        int pieces = 1 + (int) (length / map.resolution() * 10);
        for (int i = 0; i <= pieces; i++) {
            double share = (double) i / pieces;
            double x = mapFromStart.x() + share * (mapFromGoal.x() - mapFromStart.x());
            double y = mapFromStart.y() + share * (mapFromGoal.y() - mapFromStart.y());
            if (!map.isFree(x, y)) {
                return new Result.NoPath("(%s, %s) is not free.".formatted(x, y));
            }
        }
        return new Result.Found(new Path2d(List.of(mapFromStart.position(), mapFromGoal.position())), length, 0);
    }

    /// Makes it for any robot.
    public static final class Driver implements DeviceDriver {
        @Override
        public String key() {
            return "fake-planner";
        }

        @Override
        public String description() {
            return "Plans what a test tells it to.";
        }

        @Override
        public Class<? extends Device> makes() {
            return Planner.class;
        }

        @Override
        public FakePlanner create(Context context, Arguments arguments) {
            return new FakePlanner(
                    new DeviceInfo(context.robot().id(), context.name(), key()), context.map(), context.scheduler());
        }
    }
}
