package rsal.environment;

import java.util.List;

/// What a learner can do in a step. Immutable; all worlds share it.
public interface LearnerAction {
    /// What each number is, with its unit: `forward [m/s]`.
    List<String> fields();

    /// The least value of each number.
    float[] low();

    /// The greatest value of each number.
    float[] high();

    /// How many choices there are, if the only number is a choice from 0 on; 0 for continuous numbers.
    default int choices() {
        return 0;
    }

    /// Acts by a learner's robot, for one episode.
    ///
    /// @throws IllegalArgumentException when the robot lacks what it needs
    Actor of(Learner learner);

    /// Does what numbers say. On the thread that steps the episode, between two steps.
    @FunctionalInterface
    interface Actor {
        /// @param at index of the first number; all are finite and within their limits
        void act(float[] from, int at);
    }
}
