package rsal.agents;

import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// One prey's part of a hunt: follows the wall on its left until it is caught.
final class Prey {
    private final AgentContext self;
    private final Roaming wallFollowing;
    private final Reporter reporter;
    private final Surrender surrender;

    Prey(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.wallFollowing = Roaming.alongWalls(self, robot);
        this.surrender = new Surrender(
                self,
                robot,
                arguments.text(Escape.HUNTER.name()),
                arguments.number(Escape.CATCH_DISTANCE.name()),
                wallFollowing::end);
        this.reporter = new Reporter(self, robot, arguments, _ -> lookAround());
    }

    void begin() {
        self.subscribe(PoseReport.TOPIC, message -> surrender.note(message.content(), reporter.mapFromBase()));
        wallFollowing.begin();
        reporter.begin();
    }

    private void lookAround() {
        surrender.lookAround(reporter.mapFromBase());
    }
}
