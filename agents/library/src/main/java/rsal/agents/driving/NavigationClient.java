package rsal.agents.driving;

import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.data.Pose2d;
import rsal.device.GoalHandle;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;

/// Has a robot driven to one place after another. The newest counts, and none outlives the agent.
public final class NavigationClient {
    private final AgentContext self;
    private final Navigator navigator;
    private @Nullable Drive inProgress;

    public NavigationClient(AgentContext self, Navigator navigator) {
        this.self = self;
        this.navigator = navigator;
        self.atEnd(this::stop);
    }

    /// Drives to a place instead of wherever it drove before.
    ///
    /// @param onEnd told on the agent's lane, also when a later drive takes over
    public void goTo(Pose2d mapFromGoal, Tolerance tolerance, Consumer<Result> onEnd) {
        var drive = new Drive(mapFromGoal, navigator.goTo(mapFromGoal, tolerance));
        inProgress = drive;
        drive.handle
                .result()
                .thenAccept(result -> self.scheduler().execute(() -> {
                    if (drive.equals(inProgress)) {
                        inProgress = null;
                    }
                    onEnd.accept(result);
                }));
    }

    /// Whether it drives to about that place already, so that a new plan is not worth it.
    ///
    /// @param apart how far its goal may be from the place [m]
    public boolean isOnItsWayTo(Pose2d mapFromPlace, double apart) {
        return mapFromGoal()
                .filter(goal -> goal.distanceTo(mapFromPlace) < apart)
                .isPresent();
    }

    /// Where it drives; empty when it does not.
    public Optional<Pose2d> mapFromGoal() {
        return Optional.ofNullable(inProgress).map(Drive::mapFromGoal);
    }

    public void stop() {
        Drive last = inProgress;
        inProgress = null;
        if (last != null) {
            last.handle.cancel();
        }
    }

    private record Drive(Pose2d mapFromGoal, GoalHandle<Progress, Result> handle) {}
}
