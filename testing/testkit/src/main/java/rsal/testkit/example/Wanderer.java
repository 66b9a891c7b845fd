package rsal.testkit.example;

import java.time.Duration;
import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.message.NewGoal;
import rsal.agent.message.Text;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Drives about at random. Says what it was told.
public final class Wanderer implements AgentType {
    private static final Parameter<Double> SPEED = Parameter.number("speed", 0.3, 0, 1, "m/s", "How fast it drives.");

    @Override
    public String key() {
        return "wanderer";
    }

    @Override
    public String description() {
        return "Drives about at random.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(SPEED);
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
                                arguments.get(SPEED), self.random().nextDouble(-1, 1))));
        self.subscribe(
                NewGoal.TOPIC,
                goal -> self.publish(
                        Text.TOPIC,
                        new Text(goal.sender() + " wants me at "
                                + goal.content().mapFromGoal().x())));
    }
}
