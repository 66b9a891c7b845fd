package rsal.agents.patrol;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agents.driving.Roaming;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.agents.pursuit.CaptureDetector;
import rsal.agents.pursuit.Escape;
import rsal.behavior.Pilot;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// An intruder: follows the wall on its left and tells nobody where it is. What it knows of those that watch are the
/// poses they report; it gives up when one of them comes too near.
public final class Intrude extends AgentTypeBase {
    public Intrude() {
        super(
                "intrude",
                "Intruder: follows the wall on its left, and does not report its pose until it is caught.",
                List.of(Escape.HUNTER, Escape.CATCH_DISTANCE),
                List.of(Pilot.class));
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        var mapFromBase = PoseReporter.belief(robot);
        var wallFollowing = Roaming.alongWalls(self, robot);
        var surrender = new CaptureDetector(
                self,
                robot,
                arguments.get(Escape.HUNTER),
                arguments.get(Escape.CATCH_DISTANCE),
                1,
                false,
                wallFollowing::end);
        self.subscribe(PoseReport.TOPIC, message -> surrender.note(message.content(), mapFromBase.get()));
        wallFollowing.begin();
    }
}
