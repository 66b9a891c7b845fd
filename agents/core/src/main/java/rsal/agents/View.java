package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.presence.Presence;
import rsal.device.Device;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Moves stand-ins of robots in a simulated world to where the robots say they are: mixed reality. Needs no robot.
public final class View implements Agent {
    private static final Parameter ROBOT = Parameter.robots(
            "robot", NewGoal.ALL, List.of(NewGoal.ALL), "Role of the robots to show, id of the one, or all.");
    private static final Parameter PROXY = Parameter.text(
            "proxy", "proxy-*", "What its stand-in is called in the simulated world; * stands for the robot's id.");

    private final String robot;
    private final String proxy;

    View(Arguments arguments) {
        robot = arguments.text(ROBOT.name());
        proxy = arguments.text(PROXY.name());
    }

    @Override
    public void start(AgentContext self) {
        SimulationControl simulation = self.simulation()
                .orElseThrow(() -> new IllegalStateException(
                        "Agent (%s) moves stand-ins in a simulated world, but this run has none. Maybe choose a robot system that simulates, or leave the agent out."
                                .formatted(self.name())));
        self.subscribe(PoseReport.TOPIC, message -> {
            PoseReport report = message.content();
            if (robot.equals(NewGoal.ALL) || report.isFrom(robot)) {
                show(self, simulation, report);
            }
        });
        Presence.begin(self);
        self.state("showing " + robot);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    private void show(AgentContext self, SimulationControl simulation, PoseReport report) {
        String entity = proxy.replace("*", report.robot());
        switch (simulation.place(entity, report.mapFromBase())) {
            case Placement.Placed _ -> self.show(entity, Words.place(report.mapFromBase()));
            case Placement.Refused(String why) -> self.show(entity, "not placed: " + why);
        }
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "view";
        }

        @Override
        public String description() {
            return "Moves stand-ins in a simulated world to where robots say they are.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(ROBOT, PROXY);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of();
        }

        @Override
        public Agent create(Arguments arguments) {
            return new View(arguments);
        }
    }
}
