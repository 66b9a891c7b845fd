package rsal.environment;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Navigator;
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
    private int goals; // so far
    private GoalState goal = GoalState.NONE;

    /// What became of the newest goal.
    enum GoalState {
        NONE,
        UNDER_WAY,
        REACHED,
        /// No path leads there.
        NO_PATH,
        /// It got no nearer for too long, or somebody else has canceled it.
        GIVEN_UP
    }

    /// @param observations what it observes
    Learner(List<LearnerObservation> observations) {
        this.observations = observations;
    }

    @Override
    public void start(AgentContext self) {
        this.self = self;
        makers = observations.stream().map(each -> each.listen(this, self)).toList();
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

    /// Sends the navigator to a pose in the map. In the agent's turn.
    void goTo(Navigator navigator, Pose2d mapFromGoal, Navigator.Tolerance tolerance) {
        int number = ++goals;
        goal = GoalState.UNDER_WAY;
        navigator.goTo(mapFromGoal, tolerance).result().thenAccept(result -> {
            if (number == goals) {
                goal = switch (result) {
                    case Navigator.Result.Reached _ -> GoalState.REACHED;
                    case Navigator.Result.NoPath _ -> GoalState.NO_PATH;
                    case Navigator.Result.Stuck _, Navigator.Result.Cancelled _ -> GoalState.GIVEN_UP;
                };
            }
        });
    }

    /// What became of the newest goal; `NONE` before the first one.
    GoalState goal() {
        return goal;
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
