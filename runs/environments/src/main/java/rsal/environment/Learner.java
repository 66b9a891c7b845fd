package rsal.environment;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.robot.Robot;

/// The agent of a robot that a program outside drives. It repeats the newest velocity, so that the robot's watchdog
/// does not stop it during a long step. On the thread that steps the episode.
public final class Learner implements Agent {
    private static final Duration PERIOD = Duration.ofMillis(200); // less than the usual watchdog, 0.5 s

    private final List<LearnerObservation> observations;
    private List<LearnerObservation.Maker> makers = List.of();
    private @Nullable AgentContext self;
    private @Nullable Twist2d velocity;
    private boolean ended;

    /// @param observations what it observes
    Learner(List<LearnerObservation> observations) {
        this.observations = observations;
    }

    @Override
    public void start(AgentContext self) {
        this.self = self;
        makers = observations.stream().map(each -> each.listen(self)).toList();
        self.scheduler().every(PERIOD, this::repeat);
        self.atEnd(() -> ended = true);
    }

    /// Whether it has started and not ended, as when its robot is gone.
    boolean isActive() {
        return self != null && !ended;
    }

    /// Its robot.
    public Robot robot() {
        return Objects.requireNonNull(self, "A learner has a robot when it has started.")
                .robot()
                .orElseThrow();
    }

    /// What reads its observations, one for each.
    ///
    /// @throws IllegalArgumentException when the robot lacks what one needs
    List<LearnerObservation.Reader> readers(Truth world) {
        Robot robot = robot();
        return makers.stream().map(each -> each.of(robot, world)).toList();
    }

    /// Drives at a velocity from now on, until the next call.
    public void drive(Twist2d baseVelocity) {
        velocity = baseVelocity;
        run(this::repeat);
    }

    /// Does something in the agent's turn, before time passes.
    public void run(Runnable task) {
        if (isActive()) {
            Objects.requireNonNull(self).scheduler().execute(task);
        }
    }

    private void repeat() {
        if (velocity != null) {
            robot().require(DriveBase.class).command(velocity);
        }
    }
}
