package rsal.agents.driving;

import java.util.List;
import java.util.function.BiFunction;
import rsal.agent.AgentContext;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Pilot;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// Drives about by a behavior and says where it is. Driving where it is told comes first.
public abstract class Roamer extends AgentTypeBase {
    private final BiFunction<AgentContext, Robot, Roaming> roaming;

    Roamer(String key, String description, BiFunction<AgentContext, Robot, Roaming> roaming) {
        super(key, description, List.of(PoseReporter.PERIOD), List.of(Pilot.class));
        this.roaming = roaming;
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        roaming.apply(self, robot).begin();
        new PoseReporter(self, robot, arguments, _ -> {}).begin();
    }

    /// Follows the wall on its left.
    public static final class WallFollow extends Roamer {
        public WallFollow() {
            super("wall-follow", "Follows the wall on its left, and reports its pose.", Roaming::alongWalls);
        }
    }

    /// Drives about without a plan.
    public static final class Wander extends Roamer {
        public Wander() {
            super("wander", "Wanders, avoids obstacles, and reports its pose.", Roaming::anywhere);
        }
    }
}
