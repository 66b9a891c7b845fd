package rsal.navigation.device;

import java.util.List;
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
    private final BiFunction<Point2d, List<Point2d>, List<Double>> survey;
    private final Scheduler scheduler;

    /// @param search finds a way from a start to a goal; may be asked on any thread and always finds the same
    /// @param survey tells what ways from a start to goals cost; likewise
    MapPlanner(
            DeviceInfo info,
            BiFunction<Point2d, Point2d, Result> search,
            BiFunction<Point2d, List<Point2d>, List<Double>> survey,
            Scheduler scheduler) {
        super(info);
        this.search = search;
        this.survey = survey;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
        return scheduler.compute(() -> search.apply(mapFromStart.position(), mapFromGoal.position()));
    }

    @Override
    public CompletionStage<List<Double>> costs(Pose2d mapFromStart, List<Pose2d> mapFromGoals) {
        List<Point2d> goals = mapFromGoals.stream().map(Pose2d::position).toList();
        return scheduler.compute(() -> survey.apply(mapFromStart.position(), goals));
    }
}
