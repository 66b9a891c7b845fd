package rsal.engine;

import java.util.Optional;
import java.util.function.LongSupplier;
import rsal.engine.report.RunObserver;
import rsal.scenario.RunPlan;
import rsal.system.RobotRecorder;
import rsal.time.AllowedToReadWallClock;

/// Says how a run is to be executed, and starts it. None of this changes what happens in the run. Of one
/// thread.
@AllowedToReadWallClock("People drive robots in real time.")
public final class RunBuilder {
    private static final int USUAL_PATIENCE = 20; // s

    private final RunPlan plan;
    private int helpers = Math.max(1, Runtime.getRuntime().availableProcessors() - 1);
    private int patience = USUAL_PATIENCE;
    private LongSupplier operatorClock = System::nanoTime;
    private Optional<RunObserver> observer = Optional.empty();
    private Optional<RobotRecorder> recorder = Optional.empty();
    private boolean isPaused;

    RunBuilder(RunPlan plan) {
        this.plan = plan;
    }

    /// How many threads help the run's own with heavy work: usually one for each processor but one. Runs that
    /// are executed at once share the processors.
    public RunBuilder helpers(int threads) {
        this.helpers = threads;
        return this;
    }

    /// Who sees all of the run.
    public RunBuilder observer(RunObserver seen) {
        this.observer = Optional.of(seen);
        return this;
    }

    /// Who records its robots, from its first step to its end.
    public RunBuilder recorder(RobotRecorder of) {
        this.recorder = Optional.of(of);
        return this;
    }

    /// It begins paused, if its time is simulated: robots and agents come, and its first step is to be resumed.
    public RunBuilder paused() {
        this.isPaused = true;
        return this;
    }

    /// @param clock real time [ns], by which the run notices that people no longer drive a robot; any thread
    ///         asks it
    RunBuilder operatorClock(LongSupplier clock) {
        this.operatorClock = clock;
        return this;
    }

    /// @param seconds of real time after which an agent that does not return breaks the run
    RunBuilder patience(int seconds) {
        this.patience = seconds;
        return this;
    }

    /// Starts the run. Its robots and agents are made on its own thread: what goes wrong there ends its
    /// [LiveRun#result].
    public LiveRun start() {
        var loop = new RunLoop(plan, helpers, operatorClock, new RunMonitors(observer, recorder));
        if (isPaused && loop.isSimulated()) {
            loop.pause();
        }
        loop.start(patience);
        return new LiveRun(loop);
    }
}
