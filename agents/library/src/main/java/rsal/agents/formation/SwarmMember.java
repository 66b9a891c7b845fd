package rsal.agents.formation;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.Interest;
import rsal.agent.message.PoseReport;
import rsal.agents.driving.GoalService;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.PathCostService;
import rsal.agents.driving.PlaceSearch;
import rsal.agents.driving.Roaming;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Pilot;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// One of many: tells all where it is, hears where they are, follows the wall on its left, drives where it is told and
/// keeps its place in formations. Its robot needs few devices, so that hundreds fit into a run; without a pilot it
/// waits where others follow walls.
public final class SwarmMember extends AgentTypeBase {
    static final Parameter<Double> RADIUS = Parameter.number(
            "radius",
            0,
            0,
            10_000,
            "m",
            "Messages of robots farther away than this are not received; 0: messages of all robots are.");
    static final Parameter<Double> NEIGHBOR_DISTANCE = Parameter.number(
            "neighborDistance", 5, 0.1, 1000, "m", "Robots that are nearer than this are its neighbors.");

    private static final String ROAM = "roam";
    static final Parameter<String> IDLE = Parameter.choice(
            "idle", ROAM, List.of(ROAM, "wait"), "Behavior without a command; a robot without a pilot waits.");

    private static final String WAITING = "waiting for a goal";

    public SwarmMember() {
        super(
                "swarm",
                "Member of a swarm: reports its pose to all, follows the wall on its left, and drives to the goals that it receives.",
                List.of(PoseReporter.PERIOD, RADIUS, NEIGHBOR_DISTANCE, IDLE),
                List.of(Navigator.class));
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        var neighbors = new Neighbors(self, arguments.get(NEIGHBOR_DISTANCE));
        var reporter = new PoseReporter(self, robot, arguments, said -> neighbors.isAt(said.mapFromBase()));
        double radius = arguments.get(RADIUS);
        neighbors.begin(radius == 0 ? Interest.all() : PoseReport.within(radius, reporter::mapFromBase));
        var driver = new NavigationClient(self, robot.require(Navigator.class));
        if (arguments.get(IDLE).equals(ROAM) && robot.find(Pilot.class).isPresent()) {
            Roaming roaming = Roaming.alongWalls(self, robot);
            roaming.begin();
            new FormationFollower(self, robot.id(), driver, roaming::isOnErrand, roaming::pause, roaming::goOn).begin();
        } else {
            var goals = new GoalService(self, robot.id(), driver, () -> {}, () -> {});
            goals.begin();
            new FormationFollower(self, robot.id(), driver, goals::busy, () -> {}, () -> self.state(WAITING)).begin();
            self.state(WAITING);
        }
        reporter.begin();
        PathCostService.begin(self, robot, reporter);
        PlaceSearch.begin(self, robot, reporter);
        SurveyService.begin(self, robot);
    }
}
