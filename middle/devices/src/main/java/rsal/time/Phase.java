package rsal.time;

/// The order in which things happen at one instant. Tasks of an earlier phase run before those of a later one
/// that are due at the same time; within a phase they run in the order in which they were scheduled.
public enum Phase {
    /// The robot system: commands take effect, things move, sensors look, readings are delivered.
    WORLD,
    /// Software devices: estimate, plan, follow a path.
    DEVICES,
    /// Behaviors and agents decide.
    THINK,
    /// The run evaluates its stop conditions and metrics.
    OBSERVE
}
