package rsal.data;

/// A reading to which errors can be added, as faults of sensors do.
public interface Perturbable<T extends Perturbable<T>> {
    /// The same reading, wrong by so much.
    ///
    /// @param range away from what measures, of positions to the east or ahead [m]
    /// @param left to the north or left, of positions only [m]
    /// @param angle to the left [rad]
    T withError(double range, double left, double angle);
}
