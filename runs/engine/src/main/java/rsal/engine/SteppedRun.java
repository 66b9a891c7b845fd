package rsal.engine;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.agent.platform.AgentTurns;
import rsal.device.SimulationControl;
import rsal.engine.communication.Traffic;
import rsal.engine.event.EventLog;
import rsal.engine.event.RunClock;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.operator.SentGoals;
import rsal.engine.report.RunBroken;
import rsal.engine.report.RunResult;
import rsal.robot.Robot;
import rsal.scenario.RunPlan;
import rsal.time.AllowedToReadWallClock;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;

/// A run in simulated time on the thread of the one who advances it: for programs that act between its steps, such as
/// learning environments. It starts no thread. An agent that never returns blocks it, which a [SteppedWatch] finds on
/// another thread. The same plan makes the same events as in a [LiveRun].
///
/// All methods are called on one thread.
@AllowedToReadWallClock("Its result says how long it took.")
public final class SteppedRun implements AutoCloseable {
    private final RunPlan plan;
    private final long began = System.nanoTime();
    private final LockstepScheduler time;
    private final RunClock clock;
    private final EventLog eventLog;
    private final SteppedWatch watch;
    private final AgentTurns turns = new AgentTurns();
    private final MetricsObserver metrics;
    private final RunAssembly assembly;
    private @Nullable String outcome;
    private @Nullable RunResult result;

    private SteppedRun(RunPlan plan, SteppedWatch watch) {
        this.plan = plan;
        this.watch = watch;
        this.time = new LockstepScheduler();
        this.clock = new RunClock(time);
        this.eventLog = new EventLog(clock::elapsed, () -> {}, Optional.empty());
        this.metrics = new MetricsObserver(plan, eventLog, clock);
        this.assembly = new RunAssembly(
                plan,
                time,
                clock,
                eventLog,
                metrics,
                new Traffic(eventLog, metrics, plan.communication().isPresent()),
                turns,
                new SentGoals(clock::elapsed));
    }

    /// Makes the robots and agents of a run, and lets them start. No time passes.
    ///
    /// @throws IllegalArgumentException when its time is not simulated
    /// @throws RunBroken when a robot system or an agent host can't be made
    public static SteppedRun begin(RunPlan plan) {
        return begin(plan, new SteppedWatch());
    }

    /// The same, for somebody who looks whether its agents return.
    public static SteppedRun begin(RunPlan plan, SteppedWatch watch) {
        if (plan.clock() != RunPlan.Clock.SIMULATED) {
            throw new IllegalArgumentException("Only a run in simulated time can be advanced step by step.");
        }
        var run = new SteppedRun(plan, watch);
        watch.add(run.turns);
        try {
            run.begin();
            return run;
        } catch (RuntimeException | Error e) {
            watch.remove(run.turns);
            run.assembly.close();
            throw e;
        }
    }

    private void begin() {
        assembly.begin();
        time.every(plan.step(), Phase.OBSERVE, () -> {
            if (assembly.isReady()) {
                assembly.observe().ifPresent(this::end);
            }
        });
        time.runPending();
    }

    /// Simulates some steps of the plan, fewer if the run ends meanwhile.
    ///
    /// @throws RunBroken when it can't go on
    public void advance(int steps) {
        for (int step = 0; step < steps && outcome == null; step++) {
            time.advance(plan.step());
        }
    }

    private void end(String how) {
        if (outcome == null) {
            RunEnding ending = RunEnding.of(how, plan, assembly, true);
            outcome = ending.outcome();
            eventLog.event("run", "", ending.words());
        }
    }

    /// How it ended; empty while it can go on.
    public Optional<String> outcome() {
        return Optional.ofNullable(outcome);
    }

    /// The robots that are there, by id, as their agents have them.
    public Map<String, Robot> robots() {
        return assembly.robots();
    }

    /// The truth of its world; empty when no robot is simulated.
    public Optional<SimulationControl> simulation() {
        return assembly.simulation();
    }

    /// The metrics of the scenario as they are now; those without a value are left out.
    public Map<String, Double> metrics() {
        var values = new LinkedHashMap<String, Double>();
        for (MetricsObserver.Finding finding : metrics.findings()) {
            finding.value().ifPresent(value -> values.put(finding.name(), value));
        }
        return values;
    }

    /// The names of all metrics of the scenario, also of those without a value.
    public List<String> metricNames() {
        return metrics.findings().stream().map(MetricsObserver.Finding::name).toList();
    }

    /// Ends it, if it goes on.
    ///
    /// @return its result: always the same
    public RunResult finish() {
        RunResult known = result;
        if (known == null) {
            if (outcome == null) {
                outcome = RunEnding.STOPPED;
                eventLog.event("run", "", RunEnding.of(RunEnding.STOPPED).words());
            }
            known = RunReporter.result(plan, outcome, metrics, (System.nanoTime() - began) / 1e9, eventLog, assembly);
            result = known;
            assembly.close();
            watch.remove(turns);
        }
        return known;
    }

    @Override
    public void close() {
        finish();
    }
}
