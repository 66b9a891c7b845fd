package rsal.engine;

import java.time.Duration;
import rsal.engine.communication.LinkSampler;
import rsal.engine.event.EventLog;
import rsal.engine.report.RunObserver;

/// Shows a run to its observer, as often as that wants to see it. On the run's thread.
final class ObserverFeed {
    private static final Duration PERIOD_OF_MINDS = Duration.ofSeconds(1); // of the run

    private final RunObserver observer;
    private final RunReporter reporter;
    private final EventLog eventLog;
    private final LinkSampler links = new LinkSampler(); // apart from those of people, who look when they like
    private long sequence; // of the next snapshot
    private Duration nextSnapshot = Duration.ZERO;
    private Duration nextMinds = Duration.ZERO;

    ObserverFeed(RunObserver observer, RunReporter reporter, EventLog eventLog) {
        this.observer = observer;
        this.reporter = reporter;
        this.eventLog = eventLog;
    }

    void showIfDue(RunAssembly assembly, RunReporter.Progress now) {
        Duration time = now.time();
        if (time.compareTo(nextMinds) >= 0) {
            nextMinds = time.plus(PERIOD_OF_MINDS);
            observer.looksInto(time, assembly.minds());
        }
        if (time.compareTo(nextSnapshot) >= 0) {
            nextSnapshot = nextSnapshot.plus(observer.period());
            if (nextSnapshot.compareTo(time) <= 0) { // real time may have gone on
                nextSnapshot = time.plus(observer.period());
            }
            show(now);
        }
    }

    /// Shows how everything stands, if the observer looks.
    void show(RunReporter.Progress now) {
        if (observer.looks()) {
            observer.sees(reporter.snapshot(sequence++, now, links), eventLog.hashSoFar());
        }
    }
}
