package rsal.agents.driving;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agents.parts.AgentTypeBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Stands by people who send robots: sees to it that each hears where it is sent, and tells when one does not answer.
/// Needs no robot.
public final class Dispatch extends AgentTypeBase {
    static final Parameter<String> ROBOTS = Parameter.robots(
            "robots", NewGoal.ALL, List.of(NewGoal.ALL), "Role of the robots that people send, or all.");
    static final Parameter<Double> TIMEOUT = Parameter.number(
            "timeout", 5, 2, 3600, "s", "A robot that has not reported for this time counts as silent.");

    public Dispatch() {
        super(
                "dispatch",
                "Sends the goals of people to robots, repeatedly until robots confirm them, and reports silent"
                        + " robots.",
                List.of(ROBOTS, TIMEOUT),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Dispatching(self, arguments).begin();
    }
}
