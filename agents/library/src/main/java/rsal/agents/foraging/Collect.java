package rsal.agents.foraging;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.ServiceDescription;
import rsal.agents.charging.Recharging;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Pilot;
import rsal.device.BlobFinder;
import rsal.device.Gripper;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// Collects things that others have found.
public final class Collect extends AgentTypeBase {
    private static final ServiceDescription GRIPPER = ServiceDescription.of("gripper");

    public Collect() {
        super(
                "collect",
                "Fetches things that others have found, and brings them to its depot.",
                List.of(
                        PoseReporter.PERIOD,
                        Collecting.DEPOT,
                        Collecting.DEPOT_RADIUS,
                        Recharging.CHARGERS,
                        Recharging.LOW,
                        Recharging.FULL,
                        Recharging.RANGE),
                List.of(Navigator.class, Gripper.class, BlobFinder.class, Pilot.class));
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        self.offer(GRIPPER);
        var reporter = new PoseReporter(self, robot, arguments, _ -> {});
        reporter.begin();
        new Collecting(self, robot, reporter, arguments).begin();
    }
}
