package rsal.server.live;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import rsal.engine.LiveRun;
import rsal.engine.report.Performance;
import rsal.engine.report.Snapshot;
import rsal.engine.report.Teammate;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.scene.Entity;
import rsal.server.message.Refusal;

/// The run that is shown, and its successors: one at a time. All methods may be called from any thread.
public final class CurrentRun implements AutoCloseable {
    private final Consumer<LiveRun> onStart;
    private final Function<RunPlan, LiveRun> starter;
    private volatile Numbered now;
    private boolean closed;

    /// @param number counts this server's runs, from 1
    /// @param before what all before it had counted when their successors began
    public record Numbered(int number, LiveRun run, Performance before) {
        /// What all runs have counted so far: it goes on when another run begins.
        public Performance performance() {
            return before.plus(run.performance());
        }

        public boolean isNumber(String asked) {
            return asked.equals(Integer.toString(number));
        }

        public boolean isOver() {
            return run.result().toCompletableFuture().isDone();
        }

        /// All robots that are or were there; before they are, those that are planned.
        public List<Teammate> team(Snapshot snapshot) {
            List<RunPlan.PlannedRobot> planned = run.plan().robots();
            return snapshot.team().size() < planned.size()
                    ? planned.stream().map(robot -> mate(robot.spec())).toList()
                    : snapshot.team();
        }

        private Teammate mate(RobotSpec spec) {
            Entity body = run.plan().scene().robotBodies().get(spec.id());
            return new Teammate(spec, body == null ? Optional.of(spec.model().body()) : Entity.look(body.blocks()));
        }
    }

    public CurrentRun(RunPlan first, Consumer<LiveRun> onStart) {
        this(first, onStart, LiveRun::start);
    }

    public CurrentRun(RunPlan first, Consumer<LiveRun> onStart, Function<RunPlan, LiveRun> starter) {
        this.onStart = onStart;
        this.starter = starter;
        now = begin(1, first, Performance.NONE);
    }

    public Numbered now() {
        return now;
    }

    /// Ends the run and begins another one.
    ///
    /// @param mayBegin throws a refusal when, once the run has ended, none is to begin any more
    public synchronized void restart(RunPlan next, Runnable mayBegin) {
        if (closed) {
            throw new Refusal(503, "The server is ending.");
        }
        now.run().close();
        mayBegin.run();
        now = begin(now.number() + 1, next, now.performance());
    }

    private Numbered begin(int number, RunPlan plan, Performance before) {
        LiveRun run = starter.apply(plan);
        run.remember();
        onStart.accept(run);
        return new Numbered(number, run, before);
    }

    @Override
    public synchronized void close() {
        closed = true;
        now.run().close();
    }
}
