package rsal.agents.foraging;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import rsal.agent.AgentContext;
import rsal.agents.parts.AgentTypeBase;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Standing;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Sensors on the ceiling, which see what lies under them and have robots that can collect it. In the simulated world
/// they see the truth, through walls too: places and range are to be chosen so that a sensor sees one room.
public final class OverheadCamera extends AgentTypeBase {
    static final Parameter<List<Point2d>> PLACES = Parameter.points("places", "Positions of the sensors.");
    static final Parameter<String> THINGS =
            Parameter.text("things", "Name of the things that it detects, such as 'can'.");
    static final Parameter<Double> RANGE =
            Parameter.number("range", 2.5, 0.1, 100, "m", "Radius of the area under a sensor that it sees.");
    static final Parameter<Double> PERIOD = Parameter.number("period", 1, 0.1, 60, "s", "Time between two readings.");

    private static final double LIFTED = 0.01; // m above the floor: a robot holds it

    public OverheadCamera() {
        super(
                "overhead-camera",
                "Sensors on the ceiling of a simulated world. The agent requests that robots collect the things that"
                        + " they see.",
                List.of(PLACES, THINGS, RANGE, PERIOD),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        SimulationControl world = self.simulation()
                .orElseThrow(() -> new IllegalStateException(
                        "Agent '%s' sees things in a simulated world, and there is none.".formatted(self.name())));
        var finds = new Detections(self);
        finds.begin();
        List<Point2d> places = arguments.get(PLACES);
        String name = arguments.get(THINGS);
        double range = arguments.get(RANGE);
        Duration period = arguments.seconds(PERIOD);
        self.scheduler().every(period, () -> {
            for (Standing thing : world.things()) {
                Point2d where = thing.mapFromThing().position();
                boolean seen = places.stream().anyMatch(place -> place.distanceTo(where) <= range);
                if (seen && isWanted(thing, name)) {
                    goal(thing).ifPresent(finds::see);
                }
            }
        });
        self.state("watching %d places".formatted(places.size()));
    }

    private static boolean isWanted(Standing thing, String name) {
        boolean called = thing.name().equals(name) || thing.name().matches(Pattern.quote(name) + "-\\d+");
        return called && thing.height() < LIFTED;
    }

    private static Optional<CollectGoal> goal(Standing thing) {
        return thing.body().pieces().stream()
                .flatMap((Prism piece) -> piece.color().stream())
                .findFirst()
                .map(color -> new CollectGoal(color, thing.mapFromThing().position()));
    }
}
