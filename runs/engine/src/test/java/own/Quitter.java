package own;

import java.time.Duration;
import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agents.pursuit.Caught;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A prey that drives about at random, and says that it is caught when its time is up.
public final class Quitter implements AgentType {
    private static final Parameter SPEED = Parameter.number("speed", 0.3, 0, 1, "m/s", "How fast it drives.");
    private static final Parameter CAUGHT_AFTER =
            Parameter.number("caughtAfter", 1000, 0, 1000, "s", "When it gives up.");
    private static final Parameter DISTANCE =
            Parameter.number("distance", 1, 0, 1000, "m", "How far away it says that this robot is.");
    private static final Parameter BY = Parameter.text("by", "nobody", "Robot that it says caught it.");

    @Override
    public String key() {
        return "quitter";
    }

    @Override
    public String description() {
        return "Drives about at random and gives up.";
    }

    @Override
    public List<Parameter> parameters() {
        return List.of(SPEED, CAUGHT_AFTER, BY, DISTANCE);
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class);
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> start(self, arguments);
    }

    private static void start(AgentContext self, Arguments arguments) {
        var robot = self.robot().orElseThrow();
        var base = robot.require(DriveBase.class);
        self.state("wandering");
        self.scheduler()
                .every(
                        Duration.ofMillis(200),
                        () -> base.command(Twist2d.drive(
                                arguments.number("speed"), self.random().nextDouble(-1, 1))));
        self.scheduler()
                .after(
                        arguments.seconds("caughtAfter"),
                        () -> self.publish(
                                Caught.TOPIC,
                                new Caught(robot.id(), arguments.text("by"), arguments.number("distance"))));
    }
}
