package rsal.scenario.condition;

/// What is known of a run at an instant: all that a condition can ask.
public interface Facts {
    /// What a quantity is now; NaN while it is not known.
    double value(Quantity quantity);

    /// Whether a quantity that counts robots of a role or things of a group counts all that there are and will
    /// be.
    boolean holdsForAll(Quantity quantity);
}
