package rsal.scenario.run;

import java.time.Duration;
import java.util.List;
import java.util.Optional;

/// What becomes of the job of one that is gone, as agents tell by their states.
///
/// @param job what it was at
/// @param taken how long after the fault another was at it; empty when none was
record Handover(String job, Optional<Duration> taken) {
    /// How long a team may take: 5 s until one counts as silent, and 3 s to give what it had to another.
    static final Duration MOST = Duration.ofSeconds(8);

    /// @param agent of the robot that is gone
    static Handover of(List<RunEvent> events, RunEvent fault, String agent) {
        String job = events.stream()
                .filter(event -> event.kind().equals("agent") && event.subject().equals(agent))
                .filter(event -> event.time().compareTo(fault.time()) < 0)
                .reduce((_, later) -> later)
                .orElseThrow()
                .text();
        return new Handover(
                job,
                events.stream()
                        .filter(event -> event.kind().equals("agent") && event.text().equals(job))
                        .filter(event -> !event.subject().equals(agent))
                        .map(RunEvent::time)
                        .filter(time -> time.compareTo(fault.time()) >= 0)
                        .findFirst()
                        .map(time -> time.minus(fault.time())));
    }
}
