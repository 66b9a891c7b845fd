package rsal.environment;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.robot.Robot;

/// Some numbers that each learner observes. Immutable; all worlds share it.
public interface LearnerObservation {
    /// What each number is, with its unit: `forward [m/s]`.
    List<String> fields();

    /// The least value of each number.
    float[] low();

    /// The greatest value of each number.
    float[] high();

    /// Reads it from a robot, for one world.
    ///
    /// @throws IllegalArgumentException when the robot lacks what it needs
    Reader of(Robot robot, Truth world);

    /// Begins to hear what its numbers are made of, for one learner. On the lane of the learner's agent, at its start.
    /// Most have nothing to hear: they read devices and the truth.
    ///
    /// @param self what the learner's agent was given at its start
    default Maker listen(Learner learner, AgentContext self) {
        return this::of;
    }

    /// Reads it from a robot, as [#of].
    @FunctionalInterface
    interface Maker {
        /// @throws IllegalArgumentException when the robot lacks what it needs
        Reader of(Robot robot, Truth world);
    }

    /// Writes the numbers of one robot as they are now. On the thread that steps the world.
    @FunctionalInterface
    interface Reader {
        /// @param at index of its first number
        void read(float[] to, int at);
    }
}
