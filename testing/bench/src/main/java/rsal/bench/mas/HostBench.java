package rsal.bench.mas;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.agent.AgentContext;
import rsal.agent.AgentHostProvider;
import rsal.agent.Topic;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.ConversationResult;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.data.Pose2d;
import rsal.scenario.installed.Providers;
import rsal.time.Scheduler;

/// What agents cost on each host that is installed, before they do anything of their own.
///
/// Names are `mas.<host>.<what>`. What: `start`, until a platform is there; `create.100` and `create.1000`, until so
/// many agents have begun; `deliveries`, the most messages heard per second when each of a hundred speaks to 99 others
/// as fast as they can listen; `load.cpu`, the share of a core that a hundred take that tell each other their poses ten
/// times a second, and `load.rate`, how many of these 99,000 messages a second arrive; `contracts`, contract nets with
/// 20 bidders that one manager ends per second.
///
/// `deliveries` and `contracts` are measured in simulated time on hosts that follow it, as most of their runs are;
/// all else in real time.
public final class HostBench implements Bench {
    static final int TEAM = 100;
    static final int BURST = 10; // messages that each says before all have heard them
    static final Duration PERIOD = Duration.ofMillis(100);
    static final Duration WARM = Duration.ofSeconds(3);
    static final Duration WINDOW = Duration.ofSeconds(5);
    static final int BIDDERS = 20;
    private static final Topic<Pose2d> POSES = new Topic<>("bench-pose", Pose2d.class);

    private final Collection<AgentHostProvider> hosts =
            Providers.byKey(AgentHostProvider.class, AgentHostProvider::key).values();

    @Override
    public List<String> names() {
        return hosts.stream().flatMap(host -> names(host).stream()).sorted().toList();
    }

    private static List<String> names(AgentHostProvider host) {
        return Stream.of("start", "create.100", "create.1000", "deliveries", "load.cpu", "load.rate", "contracts")
                .map(what -> name(host, what))
                .toList();
    }

    static String name(AgentHostProvider host, String what) {
        return "mas." + host.key() + "." + what;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (AgentHostProvider host : hosts) {
            if (wants(assignment, host, "start", "create.100", "create.1000")) {
                creation(host, assignment);
            }
            if (wants(assignment, host, "load.cpu", "load.rate")) {
                load(host, assignment);
            }
            if (wants(assignment, host, "deliveries")) {
                most(host, "deliveries", HostBench::deliveries, assignment);
            }
            if (wants(assignment, host, "contracts")) {
                most(host, "contracts", HostBench::contracts, assignment);
            }
        }
    }

    static boolean wants(BenchmarkRequest assignment, AgentHostProvider host, String... whats) {
        return assignment.wantsAny(
                Stream.of(whats).map(what -> name(host, what)).toList());
    }

    private static void creation(AgentHostProvider host, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var start = new double[repeats];
        for (int count : new int[] {100, 1000}) {
            String name = name(host, "create." + count);
            var seconds = new double[repeats];
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name, i, repeats);
                var begun = new LongAdder();
                var watch = new Stopwatch();
                try (var platform = BenchAgents.inRealTime(host)) {
                    start[i] = watch.wall();
                    platform.start(count, _ -> begun.increment());
                    platform.until(() -> begun.sum() == count);
                    seconds[i] = watch.wall() - start[i];
                }
            }
            assignment.report(Result.less(name, "s", seconds));
        }
        assignment.report(Result.less(name(host, "start"), "s", start));
    }

    private static void load(AgentHostProvider host, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var cpu = new double[repeats];
        var rate = new double[repeats];
        var heard = new LongAdder();
        try (var platform = BenchAgents.inRealTime(host)) {
            publishPoses(platform, heard);
            platform.pass(WARM);
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name(host, "load"), i, repeats);
                heard.reset();
                var watch = new Stopwatch();
                platform.pass(WINDOW);
                rate[i] = heard.sum() / watch.wall();
                cpu[i] = watch.cpu() / watch.wall();
            }
        }
        assignment.report(
                Result.less(name(host, "load.cpu"), "core", cpu), Result.more(name(host, "load.rate"), "1/s", rate));
    }

    /// Starts a hundred that tell each other their poses ten times a second.
    static void publishPoses(BenchAgents platform, LongAdder heard) {
        platform.start(TEAM, self -> {
            self.subscribe(POSES, _ -> heard.increment());
            self.scheduler().every(PERIOD, () -> self.publish(POSES, Pose2d.ORIGIN));
        });
    }

    /// Something that agents do as often as they can.
    private interface Work {
        /// Starts agents that do it.
        ///
        /// @param done counts how often it is done
        void begin(BenchAgents platform, LongAdder done);
    }

    private static void most(AgentHostProvider host, String what, Work work, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var rate = new double[repeats];
        var done = new LongAdder();
        try (var platform = BenchAgents.of(host)) {
            work.begin(platform, done);
            platform.pass(WARM);
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name(host, what), i, repeats);
                done.reset();
                var watch = new Stopwatch();
                platform.pass(WINDOW);
                rate[i] = done.sum() / watch.wall();
            }
        }
        assignment.report(Result.more(name(host, what), "1/s", rate));
    }

    /// All speak, and again once all have heard all.
    private static void deliveries(BenchAgents platform, LongAdder done) {
        var agents = new ArrayList<AgentContext>();
        var left = new int[1]; // of this burst; written in turn
        platform.start(TEAM, self -> {
            agents.add(self);
            self.subscribe(POSES, _ -> {
                done.increment();
                if (--left[0] == 0) {
                    burst(agents, left);
                }
            });
            if (agents.size() == TEAM) {
                burst(agents, left);
            }
        });
    }

    private static void burst(List<AgentContext> agents, int[] left) {
        left[0] = TEAM * (TEAM - 1) * BURST;
        for (AgentContext agent : agents) {
            // a moment later, as who says more than it may within a window is ended
            agent.scheduler()
                    .execute(() -> agent.scheduler()
                            .after(
                                    Duration.ofMillis(1),
                                    () -> IntStream.range(0, BURST).forEach(_ -> agent.publish(POSES, Pose2d.ORIGIN))));
        }
    }

    /// A manager calls, awards and calls again.
    static void contracts(BenchAgents platform, LongAdder done) {
        platform.start(BIDDERS, self -> net(self).answer(new Bidder()));
        platform.start(1, self -> {
            var calls = new Calls(
                    self.scheduler(),
                    platform.moment(),
                    net(self),
                    platform.names().subList(0, BIDDERS),
                    done);
            self.scheduler().after(Duration.ofSeconds(1), calls::call);
        });
    }

    private static ContractNet<String, Double, String> net(AgentContext self) {
        return new ContractNet<>(self, "bench", String.class, Double.class, String.class);
    }

    private record Bidder() implements ContractNet.Contractor<String, Double, String> {
        @Override
        public void called(ContractNet.Call<String, Double> call) {
            call.propose(1.0);
        }

        @Override
        public void accepted(ContractNet.Contract<String, String> contract) {
            contract.inform("done");
        }
    }

    /// @param pause before the next call
    private record Calls(
            Scheduler time,
            Duration pause,
            ContractNet<String, Double, String> net,
            List<String> bidders,
            LongAdder done)
            implements ContractNet.Manager<String, Double, String> {
        void call() {
            net.call(bidders, "task", Duration.ofSeconds(10), this);
        }

        @Override
        public ContractNet.Verdict<String> decide(ContractNet.Round<Double> round) {
            return ContractNet.Verdict.award(round.proposals().getFirst());
        }

        @Override
        public void ended(ContractNet.Proposal<Double> accepted, ConversationResult<String> how) {
            done.increment();
            time.after(pause, this::call);
        }
    }
}
