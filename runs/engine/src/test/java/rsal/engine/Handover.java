package rsal.engine;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.engine.report.RunEvent;

/// What becomes of the job of one that is gone, as agents tell by their states.
///
/// @param job what it was at
/// @param taken how long after the fault another was at it; empty when none was
record Handover(String job, Optional<Duration> taken) {
    private static final Duration SILENCE = Duration.ofSeconds(5); // after that one counts as silent
    private static final Duration TO_ALLOT = Duration.ofSeconds(3);

    /// How long a team may take in which others can leave what they are at, or are free.
    static final Duration MOST = SILENCE.plus(TO_ALLOT);

    /// How long a team may take in which whoever has a job finishes that. Who was free before the silence was noticed
    /// may have another job by then.
    ///
    /// @param agent of the robot that is gone
    /// @param idle what agents without a job say that they do
    static Duration most(List<RunEvent> events, RunEvent fault, String agent, String idle) {
        Duration noticed = fault.time().plus(SILENCE);
        List<RunEvent> others = events.stream()
                .filter(event -> isOfAgent(event) && !event.subject().equals(agent))
                .toList();
        Map<String, String> then = new HashMap<>();
        others.stream()
                .filter(event -> event.time().compareTo(noticed) <= 0)
                .forEach(event -> then.put(event.subject(), event.text()));
        Duration free = then.containsValue(idle)
                ? noticed
                : others.stream()
                        .filter(event ->
                                event.text().equals(idle) && event.time().compareTo(noticed) > 0)
                        .map(RunEvent::time)
                        .findFirst()
                        .orElseThrow();
        return free.minus(fault.time()).plus(TO_ALLOT);
    }

    /// Whether an agent says what it does; those in AgentSpeak print it.
    static boolean isOfAgent(RunEvent event) {
        return event.kind().equals("agent") || event.kind().equals("print");
    }

    /// @param agent of the robot that is gone
    static Handover of(List<RunEvent> events, RunEvent fault, String agent) {
        String job = events.stream()
                .filter(event -> isOfAgent(event) && event.subject().equals(agent))
                .filter(event -> event.time().compareTo(fault.time()) < 0)
                .reduce((_, later) -> later)
                .orElseThrow()
                .text();
        return new Handover(
                job,
                events.stream()
                        .filter(event -> isOfAgent(event) && event.text().equals(job))
                        .filter(event -> !event.subject().equals(agent))
                        .map(RunEvent::time)
                        .filter(time -> time.compareTo(fault.time()) >= 0)
                        .findFirst()
                        .map(time -> time.minus(fault.time())));
    }
}
