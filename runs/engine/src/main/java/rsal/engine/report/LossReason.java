package rsal.engine.report;

/// Why a message did not get through to one who listened.
public enum LossReason {
    /// Too far away, or behind a wall.
    RANGE,
    /// By chance, as the scenario's `loss` has it.
    CHANCE,
    /// Its sender had more to say than the bandwidth allows.
    BANDWIDTH,
    /// A fault that the scenario injects.
    FAULT
}
