package rsal.navigation.device;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.navigation.wavefront.Plan;
import rsal.time.Scheduler;

/// A planner that searches a map, on the scheduler's threads for what takes long.
final class MapPlanner extends DeviceCore implements Planner {
    private static final String MAP = "map";

    private final Supplier<? extends Search> search;
    private final Scheduler scheduler;
    private @Nullable Stamped<Asked> latest;

    /// How ways are found on a map. May be asked on any thread and always finds the same.
    interface Search {
        Plan plan(Point2d start, Point2d goal);

        /// What ways from a start to goals cost, as [Planner#costs] has it.
        List<Double> costs(Point2d start, List<Point2d> goals, double near);
    }

    /// @param search that of now, whatever is drawn meanwhile; asked for on the scheduler's thread
    MapPlanner(DeviceInfo info, Supplier<? extends Search> search, Scheduler scheduler) {
        super(info);
        this.search = search;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
        Search now = search.get();
        Instant asked = scheduler.instant();
        return scheduler
                .compute(() -> switch (now.plan(mapFromStart.position(), mapFromGoal.position())) {
                    case Plan.Found(var path, var cost, var offGoal) -> new Result.Found(path, cost, offGoal);
                    case Plan.None(var why) -> new Result.NoPath(why);
                })
                .thenApply(result -> {
                    note(asked, Asked.of(mapFromStart, mapFromGoal, result));
                    return result;
                });
    }

    @Override
    public CompletionStage<List<Double>> costs(Pose2d mapFromStart, List<Pose2d> mapFromGoals, double near) {
        Search now = search.get();
        List<Point2d> goals = mapFromGoals.stream().map(Pose2d::position).toList();
        Instant asked = scheduler.instant();
        return scheduler
                .compute(() -> now.costs(mapFromStart.position(), goals, near))
                .thenApply(costs -> {
                    if (!costs.isEmpty()) {
                        note(asked, Asked.of(mapFromStart, mapFromGoals, costs));
                    }
                    return costs;
                });
    }

    /// In real time answers may come in another order than the questions.
    private void note(Instant asked, Asked what) {
        if (latest == null || !asked.isBefore(latest.time())) {
            latest = new Stamped<>(asked, MAP, what);
        }
    }

    @Override
    public Optional<Stamped<Asked>> latest() {
        return Optional.ofNullable(latest);
    }
}
