package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.agent.AgentContext;
import rsal.agents.foraging.Spotting;
import rsal.agents.parts.PoseReporter;
import rsal.data.Point2d;
import rsal.data.Rgb;
import rsal.robot.Robot;
import rsal.settings.Parameter;

/// Tells the others where it sees intruders through a robot's camera, once a second as long as it does.
public final class IntruderDetector {
    public static final Parameter<String> INTRUDER = Parameter.text(
            "intruder",
            "",
            "Color by which its camera detects intruders, #rrggbb or a name; empty: it detects none. Needs a camera.");

    private static final Duration PERIOD = Duration.ofSeconds(1);

    private final AgentContext self;
    private final Robot robot;
    private final Spotting spotting;
    private final Consumer<Point2d> onSeen;
    private Instant due = Instant.MIN;

    /// @param onSeen told where the robot itself sees one, each time
    public IntruderDetector(
            AgentContext self, Robot robot, PoseReporter reporter, Rgb color, Consumer<Point2d> onSeen) {
        this.self = self;
        this.robot = robot;
        this.onSeen = onSeen;
        this.spotting = new Spotting(
                self, robot, reporter, Optional.of(color), Double.POSITIVE_INFINITY, seen -> see(seen.mapFromThing()));
    }

    public void begin() {
        spotting.begin();
    }

    private void see(Point2d mapFromIntruder) {
        onSeen.accept(mapFromIntruder);
        Instant now = self.scheduler().instant();
        if (!now.isBefore(due)) {
            due = now.plus(PERIOD);
            self.publish(Alarm.TOPIC, new Alarm(robot.id(), mapFromIntruder));
        }
    }
}
