package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/// What all owe that let somebody outside drive a robot (bridges, people by hand): it stands still when they
/// are silent. That counts by the clock on the wall, by which people and networks go, whatever time it is for
/// the robot.
///
/// An interface, since those who keep it often have a bench of their own to extend. Its methods are called on
/// one thread.
public interface CommandTimeoutContract {
    /// The longest that it takes until the robot is told to stand still: half a second, and a look at the
    /// clock.
    Duration MOST = Duration.ofMillis(600);

    /// The client commands the robot to move, once, and that has arrived.
    void command() throws Exception;

    /// Time passes on the clock on the wall while the client is silent. Afterwards the one that watches it has
    /// looked, and the robot has had the time to brake.
    void pass(Duration silence) throws Exception;

    /// Time passes for the robot while the clock on the wall stands.
    void advanceRobot(Duration time) throws Exception;

    /// Whether the robot moves.
    boolean isMoving() throws Exception;

    @Test
    default void movesWhileItsClientIsHeard() throws Exception {
        for (int time = 0; time < 10; time++) {
            command();
            pass(Duration.ofMillis(300));
            assertThat(isMoving()).as("after %d commands", time + 1).isTrue();
        }
    }

    @Test
    default void standsStillWhenItsClientIsSilentAndMovesAtTheNextCommand() throws Exception {
        for (int time = 0; time < 5; time++) {
            command();
            assertThat(isMoving()).isTrue();
            pass(MOST);
            assertThat(isMoving()).as("time %d", time).isFalse();
        }
    }

    @Test
    default void timeOfTheRobotDoesNotCount() throws Exception {
        command();
        advanceRobot(Duration.ofSeconds(3));
        assertThat(isMoving()).isTrue();
    }

    @Test
    default void staysStillHoweverLongNobodyIsHeard() throws Exception {
        command();
        pass(MOST);
        for (int time = 0; time < 10; time++) {
            pass(Duration.ofSeconds(1));
            assertThat(isMoving()).isFalse();
        }
    }
}
