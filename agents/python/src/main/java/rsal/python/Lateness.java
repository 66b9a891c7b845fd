package rsal.python;

import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.frame.ToWords;

/// How long what happens to an agent waits for Python in real time, where the run does not wait. Once a second its
/// metric `lateness` is the longest wait of that second [s]. When that is more than half a second, or when Python does
/// not return, it is an event, at most every ten seconds.
final class Lateness {
    private static final Duration PERIOD = Duration.ofSeconds(1);
    private static final Duration LATE = Duration.ofMillis(500);
    private static final Duration STUCK = Duration.ofSeconds(2);
    private static final Duration SILENCE = Duration.ofSeconds(10);

    private final AgentContext self;
    private final PythonWorker worker;
    private final int number;
    private Duration longest = Duration.ZERO; // in this period; of the thread that brings events
    private @Nullable Instant due; // of the next report; of the thread that brings events
    private @Nullable Instant told; // when people were; of the agent's lane

    Lateness(AgentContext self, PythonWorker worker, int number) {
        this.self = self;
        this.worker = worker;
        this.number = number;
    }

    /// Something has happened to the agent, for which Python gets an event. On the agent's lane.
    void posted(Instant now) {
        Duration busy =
                worker.turnBegan().map(began -> Duration.between(began, now)).orElse(Duration.ZERO);
        Optional<String> place = busy.compareTo(STUCK) > 0 ? worker.place(number) : Optional.empty();
        boolean isTime = place.isPresent() || busy.compareTo(STUCK.multipliedBy(2)) > 0;
        if (isTime && !worker.isDebugged()) {
            tell(
                    now,
                    "waits: Python has not returned for %s%s"
                            .formatted(
                                    words(busy),
                                    place.map("; it is at "::concat).orElse("")));
        }
    }

    /// Python gets the event. On the thread that brings it.
    ///
    /// @param since when the agent has waited for it
    void brought(Instant since, Instant now) {
        Duration late = Duration.between(since, now);
        longest = late.compareTo(longest) > 0 ? late : longest;
        if (due == null) {
            due = now.plus(PERIOD);
        } else if (!now.isBefore(due)) {
            due = now.plus(PERIOD);
            Duration reported = longest;
            longest = Duration.ZERO;
            self.scheduler().execute(() -> report(reported));
        }
    }

    private void report(Duration late) {
        self.metric("lateness", ToWords.seconds(late));
        if (late.compareTo(LATE) > 0) {
            tell(self.scheduler().instant(), "is late: what happens waits up to %s for Python".formatted(words(late)));
        }
    }

    private void tell(Instant now, String words) {
        if (told == null || !now.isBefore(told.plus(SILENCE))) {
            told = now;
            self.print(words);
        }
    }

    private static String words(Duration time) {
        return String.format(Locale.ROOT, "%.1f s", ToWords.seconds(time));
    }
}
