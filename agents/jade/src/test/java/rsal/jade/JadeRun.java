package rsal.jade;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import rsal.agent.Agent;
import rsal.agent.AgentSpec;
import rsal.agent.Society;
import rsal.settings.Arguments;
import rsal.testkit.fake.TestedType;
import rsal.time.Phase;
import rsal.time.Task;
import rsal.time.WallScheduler;

/// Agents of ours on JADE, and JADE agents of the test among them.
final class JadeRun implements AutoCloseable {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final WallScheduler time = new WallScheduler("tested run", Runnable::run, failures::add);
    private final JadeHost host = JadeHost.start(time, Set.of());
    private final Society society = ask(() -> new Society(time, host, Optional.empty()));

    Society society() {
        return society;
    }

    void start(String name, Agent agent) {
        act(() -> society.start(new AgentSpec(
                name, "tested", new TestedType(agent), Arguments.defaults(List.of()), Optional.empty(), 1)));
    }

    /// A JADE agent that listens to some topics.
    Witness witness(String name, String... topics) {
        var witness = new Witness(topics);
        host.platform().start(name, witness);
        witness.waitUntilStarted();
        return witness;
    }

    void act(Runnable deed) {
        ask(() -> {
            deed.run();
            return true;
        });
    }

    <T> T ask(Supplier<T> question) {
        var answer = new CompletableFuture<T>();
        time.exclusively(() -> {
            try {
                answer.complete(question.get());
            } catch (RuntimeException | Error e) {
                answer.completeExceptionally(e);
            }
        });
        return await(answer, "its turn");
    }

    void until(String what, BooleanSupplier done) {
        var reached = new CompletableFuture<Boolean>();
        Task looks = time.every(Duration.ofMillis(5), Phase.OBSERVE, () -> {
            if (done.getAsBoolean()) {
                reached.complete(true);
            }
        });
        await(reached, what);
        looks.cancel();
    }

    private static <T> T await(CompletableFuture<T> future, String what) {
        try {
            return future.get(20, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            throw new AssertionError(what, e.getCause());
        } catch (InterruptedException | TimeoutException e) {
            throw new AssertionError(what, e);
        }
    }

    @Override
    public void close() {
        act(society::close);
        time.close();
        assertThat(failures).isEmpty();
    }
}
