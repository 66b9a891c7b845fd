package rsal.bench.mas;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import rsal.agent.Agent;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.platform.AgentPlatform;
import rsal.bench.measurement.Stopwatch;
import rsal.settings.Arguments;
import rsal.time.AllowedToReadWallClock;
import rsal.time.LockstepScheduler;
import rsal.time.Scheduler;
import rsal.time.WallScheduler;

/// Agents of one host, without robots.
@AllowedToReadWallClock("Benchmarks measure real time.")
final class BenchAgents implements AutoCloseable {
    private static final Duration STEP = Duration.ofMillis(1);

    private final Scheduler time;
    private final AgentPlatform platform;
    private final List<String> names = new ArrayList<>();

    private BenchAgents(AgentHostProvider host, Scheduler time) {
        this.time = time;
        var made = new AgentPlatform[1];
        act(() -> made[0] =
                new AgentPlatform(time, host.create(Arguments.defaults(host.parameters()), time), Optional.empty()));
        this.platform = made[0];
    }

    static BenchAgents inRealTime(AgentHostProvider host) {
        return new BenchAgents(host, new WallScheduler("benched", Runnable::run));
    }

    /// In simulated time where the host follows that.
    static BenchAgents of(AgentHostProvider host) {
        return host.followsSchedulerTime() ? new BenchAgents(host, new LockstepScheduler()) : inRealTime(host);
    }

    /// Time to let pass before an agent does again what it did, as one that does too much at one instant is ended.
    /// Costs nothing in simulated time; in real time there are no instants.
    Duration moment() {
        return time instanceof LockstepScheduler ? STEP : Duration.ZERO;
    }

    /// Names of those who were started.
    List<String> names() {
        return List.copyOf(names);
    }

    void start(int count, Agent agent) {
        var type = new Same(agent);
        var specs = new ArrayList<AgentSpec>();
        for (int i = 0; i < count; i++) {
            int number = names.size() + i;
            specs.add(spec("agent-" + number, number, type, Map.of()));
        }
        start(specs);
    }

    /// @param number among its kind, from which its randomness comes
    static AgentSpec spec(String name, int number, AgentType type, Map<String, ?> arguments) {
        return new AgentSpec(
                name, "benched", type, Arguments.of(type.parameters(), arguments), Optional.empty(), number + 1);
    }

    /// Starts agents of which none has begun before all are there.
    void start(List<AgentSpec> specs) {
        act(() -> specs.forEach(spec -> {
            names.add(spec.name());
            platform.start(spec);
        }));
    }

    /// What an agent reveals of itself; empty when it has not begun.
    <T> Optional<T> look(String agent, Class<T> type) {
        var seen = new AtomicReference<Optional<T>>(Optional.empty());
        act(() -> seen.set(platform.look(agent, type)));
        return seen.get();
    }

    /// Waits until something is so.
    void until(BooleanSupplier done) {
        while (!done.getAsBoolean()) {
            LockSupport.parkNanos(100_000);
        }
    }

    /// Lets so much real time pass, or simulated time for as long.
    void pass(Duration real) {
        if (time instanceof LockstepScheduler simulated) {
            var watch = new Stopwatch();
            while (watch.wall() < real.toNanos() * 1e-9) {
                simulated.advance(STEP);
            }
        } else {
            LockSupport.parkNanos(real.toNanos());
        }
    }

    private void act(Runnable deed) {
        if (time instanceof WallScheduler) {
            time.exclusively(deed);
        } else {
            deed.run();
        }
    }

    @Override
    public void close() {
        act(platform::close);
        if (time instanceof WallScheduler real) {
            real.close();
        }
    }

    /// A type of which all are the same agent.
    private record Same(Agent agent) implements AgentType {
        @Override
        public String key() {
            return "benched";
        }

        @Override
        public String description() {
            return "Does what a benchmark wants.";
        }

        @Override
        public Agent create(Arguments arguments) {
            return agent;
        }
    }
}
