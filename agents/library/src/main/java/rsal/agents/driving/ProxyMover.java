package rsal.agents.driving;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.AgentWords;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Moves stand-ins of robots in a simulated world to where the robots say they are: mixed reality with robots
/// that are not of this run; those that are can have a `proxy`. Needs no robot.
public final class ProxyMover extends AgentTypeBase {
    private static final Parameter<String> ROBOT = Parameter.robots(
            "robot", NewGoal.ALL, List.of(NewGoal.ALL), "Role of the robots to show, id of one robot, or all.");
    private static final Parameter<String> PROXY = Parameter.text(
            "proxy", "proxy-*", "Name of the proxy of a robot in the simulated world; * stands for the robot's id.");

    public ProxyMover() {
        super(
                "view",
                "Moves proxies in a simulated world to the poses that robots report.",
                List.of(ROBOT, PROXY),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        SimulationControl simulation = self.simulation()
                .orElseThrow(() -> new IllegalStateException(
                        "Agent '%s' moves proxies in a simulated world, but this run has none. Choose a robot system that simulates, or remove the agent."
                                .formatted(self.name())));
        String robot = arguments.get(ROBOT);
        String proxy = arguments.get(PROXY);
        self.subscribe(PoseReport.TOPIC, message -> {
            PoseReport report = message.content();
            if (robot.equals(NewGoal.ALL) || report.isFrom(robot)) {
                show(self, simulation, proxy.replace("*", report.robot()), report);
            }
        });
        self.state("showing " + robot);
    }

    private static void show(AgentContext self, SimulationControl simulation, String entity, PoseReport report) {
        switch (simulation.placeAnyway(entity, report.mapFromBase())) {
            case Placement.Placed _ -> self.show(entity, AgentWords.place(report.mapFromBase()));
            case Placement.Refused(String why) -> self.show(entity, "not placed: " + why);
        }
    }
}
