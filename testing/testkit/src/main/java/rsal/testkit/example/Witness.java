package rsal.testkit.example;

import java.time.Duration;
import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.data.Pose2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Shows how near a robot has been to a place in truth [m].
public final class Witness implements AgentType {
    private static final Parameter<String> OF = Parameter.robots("of", "prey", List.of(), "Id of the robot.");
    private static final Parameter<Double> X = Parameter.number("x", 0, -1000, 1000, "m", "Where the place is.");
    private static final Parameter<Double> Y = Parameter.number("y", 0, -1000, 1000, "m", "Where the place is.");

    public static final String NEAREST = "nearest";

    @Override
    public String key() {
        return "witness";
    }

    @Override
    public String description() {
        return "Shows how near a robot has been to a place.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(OF, X, Y);
    }

    @Override
    public Agent create(Arguments arguments) {
        var place = new Pose2d(arguments.get(X), arguments.get(Y), 0);
        return self -> watch(self, arguments.get(OF), place);
    }

    private static void watch(AgentContext self, String robot, Pose2d place) {
        var simulation = self.simulation().orElseThrow();
        double[] nearest = {Double.POSITIVE_INFINITY};
        self.scheduler().every(Duration.ofMillis(100), () -> {
            double distance = simulation.truth(robot).orElseThrow().distanceTo(place);
            nearest[0] = Math.min(nearest[0], distance);
            self.show(NEAREST, Double.toString(nearest[0]));
        });
    }
}
