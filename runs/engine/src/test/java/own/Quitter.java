package own;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.agents.pursuit.Caught;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.testkit.example.Wanderer;

/// A prey that drives about at random, and says that it is caught when its time is up.
public final class Quitter implements AgentType {
    private static final Wanderer WANDERER = new Wanderer();
    private static final Parameter<Double> CAUGHT_AFTER =
            Parameter.number("caughtAfter", 1000, 0, 1000, "s", "When it gives up.");
    private static final Parameter<Double> DISTANCE =
            Parameter.number("distance", 1, 0, 1000, "m", "How far away it says that this robot is.");
    private static final Parameter<String> BY = Parameter.text("by", "nobody", "Robot that it says caught it.");

    @Override
    public String key() {
        return "quitter";
    }

    @Override
    public String description() {
        return "Drives about at random and gives up.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return Stream.concat(WANDERER.parameters().stream(), Stream.of(CAUGHT_AFTER, BY, DISTANCE))
                .toList();
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return WANDERER.needs();
    }

    @Override
    public Agent create(Arguments arguments) {
        Agent wanderer = WANDERER.create(Arguments.of(
                WANDERER.parameters(), Map.of("speed", arguments.asMap().get("speed"))));
        return self -> {
            wanderer.start(self);
            String robot = self.robot().orElseThrow().id();
            self.scheduler()
                    .after(
                            arguments.seconds(CAUGHT_AFTER),
                            () -> self.publish(
                                    Caught.TOPIC, new Caught(robot, arguments.get(BY), arguments.get(DISTANCE))));
        };
    }
}
