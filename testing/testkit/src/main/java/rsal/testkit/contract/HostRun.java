package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.ChannelModel;
import rsal.agent.platform.AgentPlatform;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.testkit.fake.TestedType;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;
import rsal.time.WallScheduler;

/// A run for agents of a host under test: in simulated time where the host follows that, else in real time. All is done
/// while it is the caller's turn.
public final class HostRun implements AutoCloseable {
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    /// Said of what went wrong outside of agents.
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    private final AtomicInteger begun = new AtomicInteger(); // of those it has started
    private final Optional<LockstepScheduler> simulated;
    private final Scheduler scheduler;
    private final AgentPlatform platform;
    private int started;

    /// @param settings what is not as its fallback
    HostRun(AgentHostProvider provider, Map<String, Object> settings) {
        this(
                provider.followsSchedulerTime() ? Optional.of(new LockstepScheduler()) : Optional.empty(),
                time -> provider.create(Arguments.of(provider.parameters(), settings), time));
    }

    /// On a host that is made otherwise than with its fallbacks.
    public static HostRun inRealTime(Function<Scheduler, AgentHost> host) {
        return new HostRun(Optional.empty(), host);
    }

    private HostRun(Optional<LockstepScheduler> simulated, Function<Scheduler, AgentHost> host) {
        this.simulated = simulated;
        scheduler = simulated
                .<Scheduler>map(time -> time)
                .orElseGet(() -> new WallScheduler("tested run", Runnable::run, failures::add));
        platform = ask(() -> new AgentPlatform(scheduler, host.apply(scheduler), Optional.empty()));
    }

    Scheduler scheduler() {
        return scheduler;
    }

    public AgentPlatform platform() {
        return platform;
    }

    public void start(String name, Agent agent) {
        start(name, new TestedType(agent), Arguments.defaults(List.of()), Optional.empty());
    }

    void start(String name, Agent agent, Robot robot) {
        start(name, new TestedType(agent), Arguments.defaults(List.of()), Optional.of(robot));
    }

    void start(String name, AgentType type, Arguments arguments) {
        start(name, type, arguments, Optional.empty());
    }

    private void start(String name, AgentType type, Arguments arguments, Optional<Robot> robot) {
        var noting = new Noting(type, begun::incrementAndGet);
        started++;
        act(() -> platform.start(new AgentSpec(name, "tested", noting, arguments, robot, name.hashCode())));
    }

    void untilAllHaveBegun() {
        until("all have begun", () -> begun.get() == started);
    }

    /// Notes when its agents have begun.
    private record Noting(AgentType type, Runnable begun) implements AgentType {
        @Override
        public String key() {
            return type.key();
        }

        @Override
        public String description() {
            return type.description();
        }

        @Override
        public Agent create(Arguments arguments) {
            Agent agent = type.create(arguments);
            return new Agent() {
                @Override
                public void start(AgentContext self) {
                    agent.start(self);
                    begun.run();
                }

                @Override
                public void stop(AgentContext self) {
                    agent.stop(self);
                }
            };
        }
    }

    void stop(String name) {
        act(() -> platform.stop(name));
    }

    void deliverBy(ChannelModel channel) {
        act(() -> platform.deliverBy(channel));
    }

    AgentPlatform.Status status(String name) {
        return ask(() -> platform.views().stream()
                .filter(view -> view.agent().name().equals(name))
                .map(AgentPlatform.View::status)
                .findFirst()
                .orElseThrow());
    }

    public void act(Runnable deed) {
        ask(() -> {
            deed.run();
            return true;
        });
    }

    /// Done at the run's next turn, and what it throws is thrown here.
    public <T> T ask(Supplier<T> question) {
        if (simulated.isPresent()) {
            return question.get();
        }
        var answer = new CompletableFuture<T>();
        scheduler.exclusively(() -> {
            try {
                answer.complete(question.get());
            } catch (RuntimeException | Error e) {
                answer.completeExceptionally(e);
            }
        });
        return await(answer, "its turn");
    }

    /// Lets time pass until it is so; fails when it never is.
    public void until(String what, BooleanSupplier done) {
        if (simulated.isPresent()) {
            LockstepScheduler time = simulated.get();
            Duration end = time.elapsed().plus(PATIENCE);
            while (!done.getAsBoolean() && time.elapsed().compareTo(end) < 0) {
                time.advance(Duration.ofMillis(10));
            }
            assertThat(done.getAsBoolean()).as(what).isTrue();
        } else {
            var reached = new CompletableFuture<Boolean>();
            Task looks = scheduler.every(Duration.ofMillis(5), Phase.OBSERVE, () -> {
                if (done.getAsBoolean()) {
                    reached.complete(true);
                }
            });
            await(reached, what);
            looks.cancel();
        }
    }

    /// Lets time pass until so much is counted. A busy machine may take its time, so it fails only when nothing
    /// more is counted for a while.
    void untilCounted(String what, IntSupplier count, int wanted) {
        for (int counted = ask(count::getAsInt); counted < wanted; counted = ask(count::getAsInt)) {
            int before = counted;
            until("%s: more than %d of %d".formatted(what, before, wanted), () -> count.getAsInt() > before);
        }
        assertThat(ask(count::getAsInt)).as(what).isEqualTo(wanted);
    }

    void pass(long millis) {
        var over = new ArrayList<Boolean>();
        act(() -> scheduler.after(Duration.ofMillis(millis), Phase.OBSERVE, () -> over.add(true)));
        until("time passes", () -> !over.isEmpty());
    }

    private static <T> T await(CompletableFuture<T> future, String what) {
        try {
            return future.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            throw new AssertionError(what, e.getCause());
        } catch (InterruptedException | TimeoutException e) {
            throw new AssertionError(what, e);
        }
    }

    @Override
    public void close() {
        act(platform::close);
        if (scheduler instanceof WallScheduler time) {
            time.close();
        }
        assertThat(failures).isEmpty();
    }
}
