package rsal.agents.pursuit.strategy;

import java.util.Optional;

/// How one hunter decides where it drives. Keeps what it needs to remember; is asked on one thread, again and again,
/// also while no prey is known.
public interface PursuitStrategy {
    /// @return where it drives now; empty: it waits, or looks from place to place if it knows prey by sight
    Optional<PursuitOrder> decide(PursuitView view);

    /// Whether the hunter sends its goals to the others ([PursuitView#goals]).
    default boolean sendsGoals() {
        return true;
    }
}
