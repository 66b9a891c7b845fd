package rsal.testkit.example;

import java.time.Duration;
import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.settings.Arguments;

/// Switches its motors on at each step, and drives ahead.
public final class Stubborn implements AgentType {
    @Override
    public String key() {
        return "stubborn";
    }

    @Override
    public String description() {
        return "Switches its motors on at each step, and drives ahead.";
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class);
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> {
            var base = self.robot().orElseThrow().require(DriveBase.class);
            self.scheduler().every(Duration.ofMillis(100), () -> {
                base.enable(true);
                base.command(Twist2d.drive(0.2, 0));
            });
        };
    }
}
