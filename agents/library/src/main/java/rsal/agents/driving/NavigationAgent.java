package rsal.agents.driving;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// Drives where it is told and says where it is.
public final class NavigationAgent extends AgentTypeBase {

    public NavigationAgent() {
        super(
                "nav",
                "Drives to the goals that it receives, and reports its pose and each arrival.",
                List.of(PoseReporter.PERIOD),
                List.of(Navigator.class));
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        var driver = new NavigationClient(self, robot.require(Navigator.class));
        new GoalService(self, robot.id(), driver, () -> {}, () -> {}).begin();
        var reporter = new PoseReporter(self, robot, arguments, _ -> {});
        reporter.begin();
        PathCostService.begin(self, robot, reporter);
        PlaceSearch.begin(self, robot, reporter);
        self.state("waiting for a goal");
    }
}
