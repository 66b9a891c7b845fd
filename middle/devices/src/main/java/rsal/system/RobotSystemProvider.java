package rsal.system;

import java.util.List;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Scheduler;

/// A kind of robot system, found by [java.util.ServiceLoader] and named by its key in a scenario (`mrs: {use:
/// sim}`).
public interface RobotSystemProvider {
    /// `sim`, `player`, `ros2`.
    String key();

    /// For people: a sentence.
    String description();

    /// Whether it can follow simulated time. When not, scenarios on a simulated clock refuse it at start.
    boolean followsSchedulerTime();

    /// Whether the run follows the time of the robots' own simulator, which its system says
    /// ([RobotSystem#onTime]), instead of real time. At most one system of a run does so.
    default boolean drivesTime(Arguments settings) {
        return false;
    }

    /// What may be set beside `use`, for validation, help and the schema.
    List<Parameter<?>> parameters();

    /// Whether motors are off until somebody switches them on.
    default boolean startsDisarmed(Arguments settings) {
        return false;
    }

    /// Makes the system without starting anything.
    ///
    /// @throws InvalidRobots when it can't have these robots in this world
    RobotSystem create(Config config, Scheduler scheduler);

    /// @param scene for those who simulate it
    /// @param seed all randomness of the system comes from it
    record Config(Arguments settings, Scene scene, List<RobotSpec> robots, long seed) {
        public Config {
            robots = List.copyOf(robots);
        }
    }

    /// What is wrong with which robots: a start pose inside a wall, a sensor the system doesn't have.
    final class InvalidRobots extends IllegalArgumentException {
        private static final long serialVersionUID = 1;
        private final transient List<Problem> problems;

        public InvalidRobots(List<Problem> problems) {
            super(problems.stream()
                    .map(p -> p.robot() + ": " + p.message())
                    .reduce((a, b) -> a + "\n" + b)
                    .orElse(""));
            this.problems = List.copyOf(problems);
        }

        public List<Problem> problems() {
            return problems;
        }

        /// @param setting what in the robot's entry is to blame (`pose`, `model`)
        public record Problem(String robot, String setting, String message) {}
    }
}
