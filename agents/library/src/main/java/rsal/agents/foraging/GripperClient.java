package rsal.agents.foraging;

import java.util.function.Consumer;
import rsal.agent.AgentContext;
import rsal.data.GripperState;
import rsal.data.Stamped;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.Gripper.Result;

/// A robot's gripper, as its agent uses it. What ended is told on the agent's lane, also when something newer took
/// over.
final class GripperClient {
    private final AgentContext self;
    private final Gripper gripper;

    GripperClient(AgentContext self, Gripper gripper) {
        this.self = self;
        this.gripper = gripper;
    }

    void closeAndLift(Consumer<Result> onEnd) {
        publish(gripper.closeAndLift(), onEnd);
    }

    void lowerAndOpen(Consumer<Result> onEnd) {
        publish(gripper.lowerAndOpen(), onEnd);
    }

    private void publish(GoalHandle<GripperState, Result> goal, Consumer<Result> onEnd) {
        goal.result().thenAccept(result -> self.scheduler().execute(() -> onEnd.accept(result)));
    }

    boolean isHolding() {
        return gripper.latest()
                .map(Stamped::value)
                .filter(GripperState::holding)
                .isPresent();
    }
}
