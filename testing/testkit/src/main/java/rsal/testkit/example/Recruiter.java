package rsal.testkit.example;

import java.time.Duration;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Thing;
import rsal.settings.Arguments;

/// Adds robots and things every second, and after a while takes the first ones out again.
public final class Recruiter implements AgentType {
    @Override
    public String key() {
        return "recruiter";
    }

    @Override
    public String description() {
        return "Adds robots and takes them out again.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return Recruiter::start;
    }

    private static void start(AgentContext self) {
        SimulationControl world = self.simulation().orElseThrow();
        int[] count = {0};
        self.scheduler().every(Duration.ofSeconds(1), () -> {
            int now = count[0]++;
            world.addRobot("extra-" + now, "prey", new Pose2d(-20 + 4.0 * (now % 10), -1, now));
            world.add(Thing.of(
                            "post-" + now,
                            new Pose2d(-18 + 4.0 * (now % 10), -1, 0),
                            Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.1), 0.5),
                            new Rgb(200, 0, 0))
                    .asObstacle());
            world.removeRobot("extra-" + (now - 3));
            world.remove("post-" + (now - 5));
            if (now == 6) {
                world.removeRobot("hunter-1");
            }
        });
    }
}
