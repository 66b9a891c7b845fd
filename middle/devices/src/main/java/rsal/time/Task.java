package rsal.time;

/// Something scheduled.
public interface Task {
    /// It will not run (again). Cancelling twice, or after it ran, does nothing.
    void cancel();
}
