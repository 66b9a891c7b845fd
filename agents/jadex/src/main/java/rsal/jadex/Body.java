package rsal.jadex;

import jadex.bridge.IExternalAccess;
import jadex.bridge.IInternalAccess;
import jadex.bridge.service.ServiceScope;
import jadex.bridge.service.annotation.OnInit;
import jadex.bridge.service.search.ServiceQuery;
import jadex.commons.future.Future;
import jadex.commons.future.IFuture;
import jadex.micro.annotation.Agent;
import jadex.micro.annotation.ProvidedService;
import jadex.micro.annotation.ProvidedServices;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import rsal.time.Scheduler;

/// An agent as Jadex has it: a micro agent that does what it is handed in steps of its own, several in one when they
/// come faster than it is scheduled.
@Agent
@ProvidedServices(@ProvidedService(type = Hearing.class, scope = ServiceScope.PLATFORM))
public final class Body implements Hearing, Executor {
    private static final Logger LOG = System.getLogger(Body.class.getName());

    private final String name;
    private final Scheduler run;
    private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
    private final AtomicBoolean isDue = new AtomicBoolean();
    private final Map<Body, Hearing> others = new HashMap<>(); // of its own steps
    private volatile @Nullable IExternalAccess access; // once it is there
    private volatile boolean ended;

    @Agent
    private @Nullable IInternalAccess self; // set by Jadex

    Body(String name, Scheduler run) {
        this.name = name;
        this.run = run;
    }

    @OnInit
    IFuture<Void> begin(IInternalAccess agent) {
        access = agent.getExternalAccess();
        wake();
        return IFuture.DONE;
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
        IExternalAccess there = access;
        if (there != null && !tasks.isEmpty() && isDue.compareAndSet(false, true)) {
            there.scheduleStep(agent -> {
                        work();
                        return IFuture.DONE;
                    })
                    .catchEx(e -> {
                        if (!ended) {
                            LOG.log(Level.ERROR, () -> "Agent (%s) could not take its turn.".formatted(name), e);
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

    /// Says something to another by that one's service.
    void say(Body other, Spoken said) {
        execute(() -> {
            try {
                others.computeIfAbsent(other, this::find).hear(said).catchEx(e -> unheard(other, e));
            } catch (RuntimeException e) { // it is gone
                unheard(other, e);
            }
        });
    }

    private void unheard(Body other, Exception why) {
        LOG.log(Level.DEBUG, () -> "(%s) can't tell (%s) anything.".formatted(name, other.name), why);
    }

    /// The other's service as Jadex gives it to this agent, and to no other.
    private Hearing find(Body other) {
        return Objects.requireNonNull(self)
                .getLocalService(new ServiceQuery<>(Hearing.class)
                        .setScope(ServiceScope.PLATFORM)
                        .setProvider(Objects.requireNonNull(other.access).getId()));
    }

    boolean isThere() {
        return access != null && !ended;
    }

    @Override
    public IFuture<Void> hear(Spoken said) {
        execute(() -> run.exclusively(() -> said.arrival().accept(name)));
        return IFuture.DONE;
    }

    /// Ends it soon. Nothing more is done that it was handed.
    ///
    /// @return done when it is gone
    IFuture<Map<String, Object>> end() {
        ended = true;
        tasks.clear();
        IExternalAccess there = access;
        return there == null ? new Future<>(Map.of()) : there.killComponent();
    }
}
