package rsal.agents.parts;

import rsal.agent.AgentContext;
import rsal.robot.Robot;

/// The robot of an agent that can't do without.
public final class RequiredRobot {
    private RequiredRobot() {}

    /// @throws IllegalStateException when the agent has none
    public static Robot of(AgentContext self) {
        return self.robot()
                .orElseThrow(() -> new IllegalStateException(
                        "Agent '%s' has no robot. Maybe the scenario should name one for agents '%s'."
                                .formatted(self.name(), self.role())));
    }
}
