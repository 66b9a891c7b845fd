package rsal.navigation.device;

import java.util.concurrent.CompletionStage;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;
import rsal.time.Scheduler;

/// A planner by [Wavefront].
final class WavefrontPlanner extends DeviceCore implements Planner {
    private final Wavefront wavefront;
    private final double goalDistance;
    private final Scheduler scheduler;

    WavefrontPlanner(DeviceInfo info, Wavefront wavefront, double goalDistance, Scheduler scheduler) {
        super(info);
        this.wavefront = wavefront;
        this.goalDistance = goalDistance;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
        return scheduler.compute(
                () -> switch (wavefront.plan(mapFromStart.position(), mapFromGoal.position(), goalDistance)) {
                    case Plan.Found(var path, var cost, var offGoal) -> new Result.Found(path, cost, offGoal);
                    case Plan.None(var why) -> new Result.NoPath(why);
                });
    }
}
