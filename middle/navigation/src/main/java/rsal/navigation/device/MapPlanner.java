package rsal.navigation.device;

import java.util.concurrent.CompletionStage;
import java.util.function.BiFunction;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.time.Scheduler;

/// A planner that searches the run's map, on the scheduler's threads for what takes long.
final class MapPlanner extends DeviceCore implements Planner {
    private final BiFunction<Point2d, Point2d, Result> search;
    private final Scheduler scheduler;

    /// @param search finds a way from a start to a goal; may be asked on any thread and always finds the same
    MapPlanner(DeviceInfo info, BiFunction<Point2d, Point2d, Result> search, Scheduler scheduler) {
        super(info);
        this.search = search;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
        return scheduler.compute(() -> search.apply(mapFromStart.position(), mapFromGoal.position()));
    }
}
