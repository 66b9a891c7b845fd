package rsal.agents.foraging;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.driving.GoalService;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.Roaming;
import rsal.agents.exploration.Viewpoints;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Pilot;
import rsal.device.BlobFinder;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.device.PlaceFinder;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Looks for things of a color, and has others collect them.
public final class Explore extends AgentTypeBase {
    private static final String VIEWPOINTS = "viewpoints";
    private static final double NARROW = 0; // rad, its view: it turns all around

    static final Parameter<String> COLOR = Parameter.text(
            "color", "", "Color of the things that it searches for, #rrggbb or a name; empty: any color.");
    static final Parameter<Double> RANGE =
            Parameter.number("range", 2, 0.3, 100, "m", "Things farther from its camera than this are ignored.");

    static final Parameter<String> ROAM = Parameter.choice(
            "roam",
            "walls",
            List.of("walls", VIEWPOINTS),
            "How it moves: along the walls, or between places that are distributed over the map. Places need a"
                    + " navigator and a device of type 'places'.");

    public Explore() {
        super(
                "explore",
                "Searches for colored things, and requests that robots collect them.",
                List.of(PoseReporter.PERIOD, ROAM, Viewpoints.COUNT, COLOR, RANGE),
                List.of(BlobFinder.class, Pilot.class));
    }

    @Override
    protected List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return arguments.get(ROAM).equals(VIEWPOINTS) ? List.of(Navigator.class, PlaceFinder.class) : List.of();
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        var reporter = new PoseReporter(self, robot, arguments, _ -> {});
        reporter.begin();
        var finds = new Detections(self);
        finds.begin();
        new Spotting(self, robot, reporter, Spotting.color(arguments, COLOR), arguments.get(RANGE), finds::see).begin();
        if (arguments.get(ROAM).equals(VIEWPOINTS)) {
            roam(self, robot, reporter, arguments.get(Viewpoints.COUNT));
        } else {
            Roaming.alongWalls(self, robot).begin();
        }
    }

    /// Between lookouts; errands come first.
    private static void roam(AgentContext self, Robot robot, PoseReporter reporter, int lookouts) {
        var driver = new NavigationClient(self, robot.require(Navigator.class));
        var roaming = new Viewpoints(self, robot, driver, reporter::mapFromBase, lookouts, () -> NARROW);
        new GoalService(self, robot.id(), driver, roaming::pause, roaming::goOn).begin();
        roaming.begin();
    }
}
