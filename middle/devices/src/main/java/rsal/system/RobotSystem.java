package rsal.system;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.Subscription;
import rsal.fault.FaultInjection;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;

/// Where robots come from: a simulated world, a set of Player servers, a ROS 2 domain.
public interface RobotSystem extends AutoCloseable {
    /// Starts the system and finds its robots, each with the hardware devices it has. Completes within
    /// [#discoveryLimit()]: with all robots, or exceptionally with a message that says what is missing.
    /// A system that [admits late robots][#admitsLateRobots()] may complete without some of them. These
    /// [appear][Change.Appeared] later.
    CompletionStage<List<Robot>> discover();

    /// How long [#discover()] takes at most; the run fails afterwards.
    default Duration discoveryLimit() {
        return Duration.ofSeconds(10);
    }

    /// Says each new time of the robots' own simulator from [#discover()] on, on any thread. To be called before that.
    /// Nothing comes where the provider does not [drive the time][RobotSystemProvider#drivesTime].
    default void onTime(Consumer<? super Instant> listener) {}

    /// The run has done all that was due by a time of the robots' own simulator, and has sent its commands. Called on
    /// the scheduler's thread, for each time of [#onTime] or the newest of several.
    default void reached(Instant time) {}

    /// Whether the run may begin before all robots are found.
    default boolean admitsLateRobots() {
        return false;
    }

    Subscription onChange(Consumer<? super Change> listener);

    /// The truth of a simulated world; empty where there is only reality.
    Optional<SimulationControl> simulation();

    /// Where its robots really are, no matter who simulates or watches them, and a way to put them elsewhere; empty
    /// where nobody knows. A world that this program does not simulate takes no things, and may be late.
    default Optional<SimulationControl> truth() {
        return simulation();
    }

    /// Puts a robot into the simulated world, whether or not there is another one like it; tells that it has appeared.
    ///
    /// @param robot with an id unique among the world's entities, and a pose
    default Placement addRobot(RobotSpec robot) {
        return new Placement.Refused("'%s' can't be added: there is no simulated world.".formatted(robot.id()));
    }

    /// Breaks robots on purpose; empty where that can't be done.
    default Optional<FaultInjection> faults() {
        return Optional.empty();
    }

    /// Stops all robots and lets go of everything. Closing twice does nothing.
    @Override
    void close();

    sealed interface Change {
        record Appeared(Robot robot) implements Change {}

        /// It can't be reached, or is broken; it may appear again.
        record Gone(String robot, String reason) implements Change {}

        /// It was taken out for good: its devices are lost, and no other robot gets its id.
        record Removed(String robot) implements Change {}
    }
}
