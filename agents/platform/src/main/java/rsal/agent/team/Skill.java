package rsal.agent.team;

import java.util.Optional;

/// What a member can do. Called on its agent's lane.
public interface Skill<J extends Job> {
    /// Where a job would lead, or what is left of it when it is under way. Quick, without effects.
    ///
    /// @return empty when this robot can't do it
    Optional<TaskRoute> course(J job);

    /// Begins a job, whose end it tells.
    void begin(J job, Work work);
}
