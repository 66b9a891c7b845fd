package rsal.cli.page;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.BindException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Optional;
import rsal.cli.terminal.Build;
import rsal.cli.terminal.Unreachable;
import rsal.engine.LiveRun;
import rsal.engine.RunBuilder;
import rsal.engine.report.RunObserver;
import rsal.foxglove.FoxgloveServer;
import rsal.recording.Origin;
import rsal.recording.Recorder;
import rsal.scenario.RunPlan;
import rsal.server.RunServer;
import rsal.system.RobotRecorder;
import rsal.time.AllowedToReadWallClock;

/// Starts runs for all who look on: recordings, Foxglove, a log, all of them or nobody. All methods may be called from
/// any thread.
@AllowedToReadWallClock("Recordings contain the time of the start.")
public final class Onlookers implements AutoCloseable {
    private final RunRecorder recorder;
    private final RobotRecordings robots;
    private final Optional<FoxgloveServer> foxglove;
    private final boolean logs;
    private final String command;

    /// @param logs whether events of runs go to the log
    /// @param command as it was typed
    Onlookers(
            RunRecorder recorder,
            RobotRecordings robots,
            Optional<FoxgloveServer> foxglove,
            boolean logs,
            String command) {
        this.recorder = recorder;
        this.robots = robots;
        this.foxglove = foxglove;
        this.logs = logs;
        this.command = command;
    }

    /// Opens the port for Foxglove, and says where.
    ///
    /// @param port 0 for any that is free
    static FoxgloveServer foxglove(int port, PrintWriter err) throws IOException {
        try {
            FoxgloveServer server = FoxgloveServer.start(port, RunServer.newToken());
            err.println("In Foxglove, open a connection to " + server.url());
            err.flush();
            return server;
        } catch (BindException _) {
            throw new Unreachable(
                    "Port %d is in use, maybe by another run or by ROS's bridge to Foxglove. Choose another by --foxglove-port."
                            .formatted(port));
        }
    }

    /// Lets them only look on while somebody else has control.
    ///
    /// @param page where that is known
    public void heed(RunServer page) {
        foxglove.ifPresent(server -> server.heed(page::heldBack));
    }

    public synchronized LiveRun start(RunPlan plan) {
        var origin = new Origin(plan, Build.name(), command, Instant.now());
        Optional<RobotRecorder> bag = robots.begin(); // first, as it may be refused
        var witnesses = new ArrayList<RunObserver>();
        recorder.begin(origin).ifPresent(witnesses::add);
        foxglove.ifPresent(server -> witnesses.add(server.next(origin)));
        RunBuilder builder = LiveRun.of(plan);
        if (!witnesses.isEmpty()) {
            builder.observer(RunObserver.all(witnesses));
        }
        bag.ifPresent(builder::recorder);
        LiveRun run = builder.start();
        if (logs) {
            RunLog.follow(run);
        }
        recorder.began(run);
        robots.began(run);
        foxglove.ifPresent(server -> server.began(run));
        return run;
    }

    /// A run has ended: ends its recording, and tells what became of that.
    public void end(LiveRun run) {
        recorder.end(run);
        robots.end(run);
    }

    /// The results of all recordings so far; empty when nothing is recorded. Does not wait.
    public Optional<Recorder.Tally> recorded() {
        return recorder.tally();
    }

    /// Whether any recording is not whole.
    public boolean hasFailed() {
        return recorder.hasFailed() || robots.hasFailed();
    }

    @Override
    public void close() {
        recorder.close();
        robots.close();
        foxglove.ifPresent(FoxgloveServer::close);
    }
}
