package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.Interest;
import rsal.agent.message.PoseReport;
import rsal.agent.presence.Presence;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// One of many: tells all where it is, hears where they are, follows the wall on its left and drives where it is told.
/// Its robot needs few devices, so that hundreds fit into a run; without a pilot it waits where others follow walls.
public final class Swarm implements Agent {
    static final Parameter RADIUS = Parameter.number(
            "radius", 0, 0, 10_000, "m", "Robots farther away than this are not heard; 0 hears all of them.");
    static final Parameter NEAR =
            Parameter.number("near", 5, 0.1, 1000, "m", "Robots that are nearer than this are its neighbors.");

    private final Arguments arguments;

    Swarm(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        Robot robot = Body.of(self);
        var neighbors = new Neighbors(self, arguments.number(NEAR.name()));
        var reporter = new Reporter(self, robot, arguments, said -> neighbors.isAt(said.mapFromBase()));
        double radius = arguments.number(RADIUS.name());
        neighbors.begin(radius == 0 ? Interest.all() : PoseReport.within(radius, reporter::mapFromBase));
        if (robot.find(Pilot.class).isPresent()) {
            Roaming.alongWalls(self, robot).begin();
        } else {
            var driver = new Driver(self, robot.require(Navigator.class));
            new Errands(self, robot.id(), driver, () -> {}, () -> {}).begin();
            self.state("waiting for a goal");
        }
        reporter.begin();
        Travel.begin(self, robot, reporter);
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "swarm";
        }

        @Override
        public String description() {
            return "One of many: tells all where it is, follows the wall on its left, drives where it is told.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Reporter.PERIOD, RADIUS, NEAR);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Navigator.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Swarm(arguments);
        }
    }
}
