package rsal.scenario.run;

import java.time.Duration;
import java.util.List;
import java.util.Optional;

/// A run at an instant. Immutable; made of references to the immutable readings of that instant.
///
/// @param sequence grows by one with each snapshot of a run
/// @param time since the run's start
/// @param stopped whether the emergency stop holds
/// @param speed simulated over real time, as asked for; +∞ for as fast as it can
/// @param rate simulated over real time, as measured
/// @param outcome how the run ended; empty while it goes on
public record Snapshot(
        long sequence,
        Duration time,
        boolean paused,
        boolean stopped,
        double speed,
        double rate,
        Optional<String> outcome,
        List<RobotView> robots,
        List<AgentView> agents) {
    public Snapshot {
        robots = List.copyOf(robots);
        agents = List.copyOf(agents);
    }
}
