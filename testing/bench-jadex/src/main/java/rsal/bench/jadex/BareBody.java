package rsal.bench.jadex;

import jadex.bridge.IComponentStep;
import jadex.bridge.IInternalAccess;
import jadex.bridge.component.IExecutionFeature;
import jadex.bridge.service.annotation.OnInit;
import jadex.commons.future.IFuture;
import jadex.micro.annotation.Agent;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import rsal.bare.BareSystem;
import rsal.bare.Life;
import rsal.data.Pose2d;

/// A micro agent without us. Public, as Jadex looks into it.
@Agent
public final class BareBody {
    private final List<BareBody> all;
    private final Life life;
    private final Queue<Pose2d> inbox = new ConcurrentLinkedQueue<>();
    private final AtomicBoolean isDue = new AtomicBoolean();
    private volatile @Nullable IExecutionFeature steps; // once it is there; proxies in front of it take as long again

    /// @param all that hear what it says, itself included, which does not
    BareBody(List<BareBody> all, Life life) {
        this.all = all;
        this.life = life;
    }

    @OnInit
    IFuture<Void> begin(IInternalAccess agent) {
        steps = agent.getFeature(IExecutionFeature.class);
        long period = life.period().toMillis();
        if (period > 0) {
            agent.repeatStep(period, period, step(() -> publish(1)));
        }
        if (!inbox.isEmpty()) { // heard before it was there
            schedule(this::read);
        }
        life.begun().run();
        return IFuture.DONE;
    }

    void say(int times) {
        schedule(() -> publish(times));
    }

    private void publish(int times) {
        for (int i = 0; i < times; i++) {
            for (BareBody other : all) {
                if (other != this) {
                    other.hear(BareSystem.POSE);
                }
            }
        }
    }

    private void hear(Pose2d pose) {
        inbox.add(pose);
        if (isDue.compareAndSet(false, true)) {
            schedule(this::read);
        }
    }

    private void read() {
        isDue.set(false); // what comes from now on may need another step
        while (inbox.poll() != null) {
            life.heard().run();
        }
    }

    private void schedule(Runnable task) {
        IExecutionFeature there = steps;
        if (there != null) {
            there.scheduleStep(step(task)).catchEx(_ -> {}); // it has ended
        }
    }

    private static IComponentStep<Void> step(Runnable task) {
        return _ -> {
            task.run();
            return IFuture.DONE;
        };
    }
}
