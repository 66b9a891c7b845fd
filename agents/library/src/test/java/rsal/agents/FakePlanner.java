package rsal.agents;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Planner;

/// All ways are straight.
public final class FakePlanner extends DeviceCore implements Planner {
    public FakePlanner(String robot) {
        super(new DeviceInfo(robot, "planner", "fake"));
    }

    @Override
    public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
        var path = new Path2d(List.of(mapFromStart.position(), mapFromGoal.position()));
        return CompletableFuture.completedFuture(new Result.Found(path, path.length(), 0));
    }
}
