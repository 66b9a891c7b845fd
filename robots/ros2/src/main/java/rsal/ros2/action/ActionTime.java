package rsal.ros2.action;

import java.time.Instant;
import rsal.time.Scheduler;

/// A scheduler whose [#instant] may begin again while the run goes on, as when a program resets a simulator.
public interface ActionTime extends Scheduler {
    /// The time of the run, which nobody resets.
    Instant ofRun();

    /// The time that messages have of what happened at a time of the run.
    Instant stamp(Instant ofRun);
}
