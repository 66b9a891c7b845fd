package rsal.bench.mas;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.LongAdder;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import rsal.agent.AgentHostProvider;
import rsal.bare.BareSystem;
import rsal.bare.Life;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.scenario.installed.Providers;
import rsal.time.AllowedToReadWallClock;

/// What multi-agent systems cost without us, and what we add.
///
/// Names are `mas.<host>.bare.<what>`, with what [HostBench] measures, for hosts whose system is there
/// ([BareSystem]); for `plain` it is what a Java programmer writes without any. `mas.<host>.overhead` is the time of
/// processors that a message takes which one hears, under the load of [HostBench], by that on the bare system;
/// `mas.<host>.overhead.contracts` the same of a contract net. Both are medians of pairs of windows, one after the
/// other.
@AllowedToReadWallClock("Benchmarks measure real time.")
public final class OverheadBench implements Bench {
    private final Collection<AgentHostProvider> hosts =
            Providers.byKey(AgentHostProvider.class, AgentHostProvider::key).values();
    private final Map<String, BareSystem> systems = Providers.byKey(BareSystem.class, BareSystem::key);

    @Override
    public List<String> names() {
        return hosts.stream()
                .filter(host -> bare(host).isPresent())
                .flatMap(host -> names(host).stream())
                .sorted()
                .toList();
    }

    private Optional<BareSystem> bare(AgentHostProvider host) {
        return Optional.ofNullable(systems.get(host.key()));
    }

    private static List<String> names(AgentHostProvider host) {
        return Stream.of(
                        "bare.start",
                        "bare.create.100",
                        "bare.create.1000",
                        "bare.deliveries",
                        "bare.load.cpu",
                        "bare.load.rate",
                        "bare.contracts",
                        "overhead",
                        "overhead.contracts")
                .map(what -> HostBench.name(host, what))
                .toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (AgentHostProvider host : hosts) {
            bare(host).ifPresent(bare -> measure(host, bare, assignment));
        }
    }

    private static void measure(AgentHostProvider host, BareSystem bare, BenchmarkRequest assignment) {
        if (HostBench.wants(assignment, host, "bare.start", "bare.create.100", "bare.create.1000")) {
            creation(host, bare, assignment);
        }
        if (HostBench.wants(assignment, host, "bare.load.cpu", "bare.load.rate", "overhead")) {
            load(host, bare, assignment);
        }
        if (HostBench.wants(assignment, host, "bare.deliveries")) {
            deliveries(host, bare, assignment);
        }
        if (HostBench.wants(assignment, host, "bare.contracts", "overhead.contracts")) {
            contracts(host, bare, assignment);
        }
    }

    private static void creation(AgentHostProvider host, BareSystem bare, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var start = new double[repeats];
        for (int count : new int[] {100, 1000}) {
            String name = HostBench.name(host, "bare.create." + count);
            var seconds = new double[repeats];
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name, i, repeats);
                var begun = new LongAdder();
                var watch = new Stopwatch();
                try (var platform = bare.start()) {
                    start[i] = watch.wall();
                    platform.start(count, new Life(Duration.ZERO, begun::increment, () -> {}));
                    until(() -> begun.sum() == count);
                    seconds[i] = watch.wall() - start[i];
                }
            }
            assignment.report(Result.less(name, "s", seconds));
        }
        assignment.report(Result.less(HostBench.name(host, "bare.start"), "s", start));
    }

    private static void load(AgentHostProvider host, BareSystem bare, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var cpu = new double[repeats];
        var rate = new double[repeats];
        var overhead = new double[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(HostBench.name(host, "overhead"), i, repeats);
            PlatformLoad ours = poses(host);
            PlatformLoad theirs = poses(bare);
            cpu[i] = theirs.cpu();
            rate[i] = theirs.rate();
            overhead[i] = ours.each() / theirs.each();
        }
        assignment.report(
                Result.less(HostBench.name(host, "bare.load.cpu"), "core", cpu),
                Result.more(HostBench.name(host, "bare.load.rate"), "1/s", rate),
                Result.less(HostBench.name(host, "overhead"), "", overhead));
    }

    private static void contracts(AgentHostProvider host, BareSystem bare, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var rate = new double[repeats];
        var overhead = new double[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(HostBench.name(host, "overhead.contracts"), i, repeats);
            PlatformLoad ours = nets(host);
            PlatformLoad theirs = nets(bare);
            rate[i] = theirs.rate();
            overhead[i] = ours.each() / theirs.each();
        }
        assignment.report(
                Result.more(HostBench.name(host, "bare.contracts"), "1/s", rate),
                Result.less(HostBench.name(host, "overhead.contracts"), "", overhead));
    }

    /// Of a hundred that tell each other their poses: messages heard.
    private static PlatformLoad poses(AgentHostProvider host) {
        var heard = new LongAdder();
        try (var agents = BenchAgents.inRealTime(host)) {
            HostBench.publishPoses(agents, heard);
            return PlatformLoad.of(heard::sum, OverheadBench::pass);
        }
    }

    private static PlatformLoad poses(BareSystem bare) {
        var heard = new LongAdder();
        try (var platform = bare.start()) {
            platform.start(HostBench.TEAM, new Life(HostBench.PERIOD, () -> {}, heard::increment));
            return PlatformLoad.of(heard::sum, OverheadBench::pass);
        }
    }

    /// Of a manager and bidders that do nothing else: contract nets ended.
    private static PlatformLoad nets(AgentHostProvider host) {
        var ended = new LongAdder();
        try (var agents = BenchAgents.of(host)) {
            HostBench.contracts(agents, ended);
            return PlatformLoad.of(ended::sum, agents::pass);
        }
    }

    private static PlatformLoad nets(BareSystem bare) {
        var ended = new LongAdder();
        try (var platform = bare.start()) {
            platform.contract(HostBench.BIDDERS, ended::increment);
            return PlatformLoad.of(ended::sum, OverheadBench::pass);
        }
    }

    /// All speak, and again once all have heard all.
    private static void deliveries(AgentHostProvider host, BareSystem bare, BenchmarkRequest assignment) {
        String name = HostBench.name(host, "bare.deliveries");
        int repeats = assignment.repeats();
        var rate = new double[repeats];
        var begun = new LongAdder();
        var heard = new LongAdder();
        long all = (long) HostBench.TEAM * (HostBench.TEAM - 1) * HostBench.BURST;
        var left = new AtomicLong(all); // of this burst
        try (var platform = bare.start()) {
            platform.start(HostBench.TEAM, new Life(Duration.ZERO, begun::increment, () -> {
                heard.increment();
                if (left.decrementAndGet() == 0) {
                    left.set(all);
                    platform.say(HostBench.BURST);
                }
            }));
            until(() -> begun.sum() == HostBench.TEAM);
            platform.say(HostBench.BURST);
            pass(HostBench.WARM);
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name, i, repeats);
                heard.reset();
                var watch = new Stopwatch();
                pass(HostBench.WINDOW);
                rate[i] = heard.sum() / watch.wall();
            }
        }
        assignment.report(Result.more(name, "1/s", rate));
    }

    /// Waits until something is so.
    static void until(BooleanSupplier done) {
        while (!done.getAsBoolean()) {
            LockSupport.parkNanos(100_000);
        }
    }

    /// Lets so much real time pass.
    static void pass(Duration real) {
        long end = System.nanoTime() + real.toNanos();
        for (long left = real.toNanos(); left > 0; left = end - System.nanoTime()) {
            LockSupport.parkNanos(left);
        }
    }
}
