package rsal.engine.report;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.device.SimulationControl.Standing;

/// A run at an instant. Immutable; made of references to the immutable readings of that instant.
///
/// @param sequence grows by one with each snapshot of a run
/// @param time since the run's start
/// @param stopped whether the emergency stop holds
/// @param speed simulated over real time, as asked for; +∞ for as fast as it can
/// @param rate simulated over real time, as measured
/// @param outcome how the run ended; empty while it goes on
/// @param robots that are there
/// @param team all robots that are or were there, in the order in which they came; the same list until it grows
/// @param things what of the simulated world is not a robot
/// @param links which robots' agents hear each other, and did within a second, as it was once in this second of the
/// run; of more than 50 robots none, and `ofChosen`
public record Snapshot(
        long sequence,
        Duration time,
        boolean paused,
        boolean stopped,
        double speed,
        double rate,
        Optional<String> outcome,
        List<RobotView> robots,
        List<AgentView> agents,
        List<Teammate> team,
        List<Standing> things,
        Answer.Linked links) {
    public Snapshot {
        robots = List.copyOf(robots);
        agents = List.copyOf(agents);
        team = List.copyOf(team);
        things = List.copyOf(things);
    }
}
