package rsal.python;

import java.util.List;
import java.util.Map;
import rsal.agent.AgentContext;

/// Gives agents in Python the observations and actions of learning environments, so that a trained policy sees as an
/// agent what it saw as a learner. Found by [java.util.ServiceLoader].
public interface ObservationService {
    /// Begins to observe for an agent. On its lane.
    ///
    /// @param observe each with its `type` and parameters
    /// @param act its `type` and parameters
    /// @throws IllegalArgumentException in a sentence for people, when the robot lacks what they need
    Observed of(AgentContext self, List<Map<String, Object>> observe, Map<String, Object> act);

    /// The observations and actions of one agent. On its lane.
    interface Observed {
        /// What an agent observes now, as an array of its own.
        float[] observe();

        /// Acts until the next time. Numbers beyond their limits count as the limit.
        ///
        /// @throws IllegalArgumentException when there are too few or too many, or one is not finite
        void act(float[] action);
    }
}
