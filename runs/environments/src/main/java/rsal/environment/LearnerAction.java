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

    /// Checks a number before anything is done. Those beyond their limits are none of its errors, but choices are.
    ///
    /// @param number which of the numbers
    /// @param robot that is to act
    /// @throws IllegalArgumentException when it is not finite, or is none of the choices
    default void check(int number, float value, String robot) {
        if (!Float.isFinite(value)) {
            throw new IllegalArgumentException("Action '%s' of robot '%s' must be finite, not '%s'."
                    .formatted(fields().get(number), robot, value));
        }
        int choices = choices();
        if (choices > 0 && (value < 0 || value >= choices || value != Math.rint(value))) {
            throw new IllegalArgumentException(
                    "Action '%s' of robot '%s' must be a whole number from 0 to %d, not '%s'."
                            .formatted(fields().get(number), robot, choices - 1, value));
        }
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
