package rsal.engine;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import rsal.engine.communication.LinkSampler;
import rsal.engine.event.EventLog;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.report.Answer;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunPlan;

/// Puts together what a run shows of itself: snapshots while it goes on, and its result. On the run's thread.
final class RunReporter {
    private final Pacer pacer;
    private final LongSupplier operatorClock;
    private final LinkSampler links = new LinkSampler();

    /// How far a run has got.
    ///
    /// @param time since its start
    /// @param outcome how it ended; empty while it goes on
    /// @param assembly its robots and agents; empty before they are made
    record Progress(Duration time, boolean paused, Optional<String> outcome, Optional<RunAssembly> assembly) {}

    /// @param operatorClock real time [ns]
    RunReporter(Pacer pacer, LongSupplier operatorClock) {
        this.pacer = pacer;
        this.operatorClock = operatorClock;
    }

    Snapshot snapshot(long sequence, Progress now) {
        return snapshot(sequence, now, links);
    }

    /// @param shown links that were shown before to the one who looks now
    Snapshot snapshot(long sequence, Progress now, LinkSampler shown) {
        return now.assembly()
                .map(all -> new Snapshot(
                        sequence,
                        now.time(),
                        now.paused(),
                        all.robotCommands().stopped(),
                        pacer.speed(),
                        rate(now),
                        now.outcome(),
                        all.robotViews(),
                        all.agentViews(),
                        all.team(),
                        all.world().things(),
                        shown.at(now.time(), () -> all.links("", operatorClock.getAsLong()))))
                .orElseGet(() -> empty(sequence, now));
    }

    private Snapshot empty(long sequence, Progress now) {
        return new Snapshot(
                sequence,
                now.time(),
                now.paused(),
                false,
                pacer.speed(),
                rate(now),
                now.outcome(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                Answer.Linked.NONE);
    }

    private double rate(Progress now) {
        return now.paused() ? 0 : pacer.rate(now.time().toNanos());
    }

    /// @param wallSeconds real time that the run took
    /// @param assembly null when the run broke before its robots and agents were made
    static RunResult result(
            RunPlan plan,
            String outcome,
            MetricsObserver observer,
            double wallSeconds,
            EventLog eventLog,
            @Nullable RunAssembly assembly) {
        var metrics = new LinkedHashMap<String, OptionalDouble>();
        var outOfBounds = new ArrayList<String>();
        for (MetricsObserver.Finding finding : observer.findings()) {
            metrics.put(finding.name(), finding.value());
            if (!finding.inBounds()) {
                outOfBounds.add(finding.name());
            }
        }
        return new RunResult(
                plan.scenario().name(),
                plan.configuration(),
                plan.seed(),
                outcome,
                observer.time(),
                wallSeconds,
                eventLog.finish(),
                metrics,
                outOfBounds,
                assembly == null ? Map.of() : assembly.poses(),
                assembly == null ? Map.of() : assembly.failedAgents(),
                assembly == null ? Map.of() : assembly.unhandledGoals(),
                assembly == null ? List.of() : assembly.topics(),
                assembly == null ? List.of() : assembly.hearings());
    }
}
