package rsal.scenario.condition;

/// What is known of a run at an instant: all that a condition can ask.
public interface Facts {
    /// Simulated time since the start [s].
    double time();

    /// Touches so far, with walls and with each other.
    long collisions();

    /// Touches so far of walls (and of all else that is no robot).
    long wallCollisions();

    /// How many robots a role has.
    int robots(String role);

    /// How many robots of a role have been caught so far.
    int caught(String role);
}
