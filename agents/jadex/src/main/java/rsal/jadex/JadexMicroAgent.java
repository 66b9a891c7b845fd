package rsal.jadex;

import jadex.bridge.IComponentStep;
import jadex.bridge.IInternalAccess;
import jadex.bridge.component.IExecutionFeature;
import jadex.bridge.service.annotation.OnEnd;
import jadex.bridge.service.annotation.OnInit;
import jadex.commons.future.Future;
import jadex.commons.future.IFuture;
import jadex.micro.annotation.Agent;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/// An agent as Jadex has it: a micro agent that does what it is handed in steps of its own, several in one when they
/// come faster than it is scheduled.
@Agent
public final class JadexMicroAgent implements Executor {
    private static final Logger LOG = System.getLogger(JadexMicroAgent.class.getName());

    private final String name;
    private final Consumer<JadexMicroAgent> killed;
    private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
    private final AtomicBoolean isDue = new AtomicBoolean();
    private final IComponentStep<Void> turn = _ -> {
        work();
        return IFuture.DONE;
    };
    private volatile @Nullable IInternalAccess access; // once it is there
    private volatile @Nullable IExecutionFeature steps; // may be handed steps by any thread, as its proxies do
    private volatile boolean ended;

    /// @param name of our agent
    /// @param killed told, on a thread of Jadex's, when Jadex has ended it by itself
    public JadexMicroAgent(String name, Consumer<JadexMicroAgent> killed) {
        this.name = name;
        this.killed = killed;
    }

    String name() {
        return name;
    }

    @OnInit
    IFuture<Void> begin(IInternalAccess agent) {
        access = agent;
        steps = agent.getFeature(IExecutionFeature.class);
        if (ended) { // before it was there
            agent.getExternalAccess().killComponent();
        }
        wake();
        return IFuture.DONE;
    }

    /// Also when nobody here wanted it to end.
    @OnEnd
    void gone() {
        access = null; // it is not to be killed again
        if (!ended) {
            ended = true;
            tasks.clear();
            killed.accept(this);
        }
    }

    /// In a step of its own, later. What is handed over after its end is dropped.
    @Override
    public void execute(Runnable task) {
        if (!ended) {
            tasks.add(task);
            wake();
        }
    }

    private void wake() {
        IExecutionFeature there = steps;
        if (there != null && !tasks.isEmpty() && isDue.compareAndSet(false, true)) {
            there.scheduleStep(turn).catchEx(e -> {
                if (!ended) {
                    LOG.log(Level.ERROR, () -> "Agent '%s' could not be executed.".formatted(name), e);
                }
            });
        }
    }

    private void work() {
        isDue.set(false); // what comes from now on may need another step
        for (Runnable task = tasks.poll(); task != null && !ended; task = tasks.poll()) {
            task.run(); // throws nothing: what is done in turn tells the run of it
        }
    }

    /// Ends it soon. Nothing more is done that it was handed.
    ///
    /// @return done when it is gone
    public IFuture<Map<String, Object>> end() {
        ended = true;
        tasks.clear();
        IInternalAccess there = access;
        return there == null
                ? new Future<>(Map.of())
                : there.getExternalAccess().killComponent();
    }
}
