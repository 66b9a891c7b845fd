package rsal.bench.mas;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.bare.BareLanguage;
import rsal.bare.BareLanguage.Platform;
import rsal.bare.BareLanguage.Program;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.scenario.installed.Providers;
import rsal.settings.Location;

/// What agents cost that are written in a language of their host, there and on the system that the language comes from
/// ([BareLanguage]), by the same programs.
///
/// Names are `mas.<host>.written.<what>` and `mas.<host>.bare.<what>`, with what [HostBench] measures.
/// `mas.<host>.written.overhead` is the time of processors that a message takes which one hears, under the load of
/// [HostBench], by that on the bare system; `mas.<host>.written.overhead.contracts` the same of a contract net. Both
/// are medians of pairs of windows, one after the other. `deliveries` are those of agents that speak again as soon as
/// they have heard all others.
public final class LanguageBench implements Bench {
    private static final String MANAGER = "manager";

    private final List<Pair> pairs = pairs();

    /// @param bare the language of the host, without us
    private record Pair(AgentHostProvider host, BareLanguage bare) {
        String name(String what) {
            return HostBench.name(host, what);
        }

        Side ours() {
            Map<Program, AgentType> types = types();
            Function<BenchAgents, Team> team = agents -> new Team(new LanguageAgents(agents, types), agents::pass);
            return new Side(
                    "written", () -> team.apply(BenchAgents.inRealTime(host)), () -> team.apply(BenchAgents.of(host)));
        }

        /// The programs as our host reads them.
        private Map<Program, AgentType> types() {
            AgentLanguage language = Objects.requireNonNull(
                    Providers.byKey(AgentLanguage.class, AgentLanguage::suffix).get(bare.suffix()), bare.suffix());
            var types = new EnumMap<Program, AgentType>(Program.class);
            for (Program program : Program.values()) {
                String file = program.name() + language.suffix();
                byte[] text = bare.text(program).getBytes(StandardCharsets.UTF_8);
                types.put(program, language.read(file, (_, _, _) -> text, Location.of(file)));
            }
            return types;
        }

        Side theirs() {
            Supplier<Team> team = () -> new Team(bare.start(), OverheadBench::pass);
            return new Side("bare", team, team);
        }
    }

    /// One of both.
    ///
    /// @param real begins agents in real time
    /// @param fast begins them in simulated time, if they know any
    private record Side(String word, Supplier<Team> real, Supplier<Team> fast) {
        String what(String what) {
            return word + "." + what;
        }
    }

    /// @param pass lets time pass for its agents
    private record Team(Platform platform, Consumer<Duration> pass) implements AutoCloseable {
        /// @param counting names of those whose counts matter
        PlatformLoad load(Map<String, Program> agents, List<String> counting) {
            platform.start(agents);
            return PlatformLoad.of(
                    () -> counting.stream().mapToLong(platform::count).sum(), pass);
        }

        @Override
        public void close() {
            platform.close();
        }
    }

    private static List<Pair> pairs() {
        Map<String, AgentHostProvider> hosts = Providers.byKey(AgentHostProvider.class, AgentHostProvider::key);
        return Providers.byKey(BareLanguage.class, BareLanguage::key).values().stream()
                .flatMap(bare ->
                        Optional.ofNullable(hosts.get(bare.key())).stream().map(host -> new Pair(host, bare)))
                .toList();
    }

    @Override
    public List<String> names() {
        return pairs.stream()
                .flatMap(pair -> Stream.concat(
                                Stream.of(
                                                "start",
                                                "create.100",
                                                "create.1000",
                                                "load.cpu",
                                                "load.rate",
                                                "deliveries",
                                                "contracts")
                                        .flatMap(what -> Stream.of("bare." + what, "written." + what)),
                                Stream.of("written.overhead", "written.overhead.contracts"))
                        .map(pair::name))
                .sorted()
                .toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (Pair pair : pairs) {
            Side ours = pair.ours();
            Side theirs = pair.theirs();
            creation(pair, ours, assignment);
            creation(pair, theirs, assignment);
            load(pair, ours, theirs, assignment);
            contracts(pair, ours, theirs, assignment);
            deliveries(pair, ours, assignment);
            deliveries(pair, theirs, assignment);
        }
    }

    private static boolean wants(BenchmarkRequest assignment, Pair pair, String... whats) {
        return HostBench.wants(assignment, pair.host, whats);
    }

    private static Map<String, Program> team(int count, Program program) {
        var team = new LinkedHashMap<String, Program>();
        IntStream.range(0, count).forEach(i -> team.put("agent" + i, program));
        return team;
    }

    private static void creation(Pair pair, Side side, BenchmarkRequest assignment) {
        if (!wants(assignment, pair, side.what("start"), side.what("create.100"), side.what("create.1000"))) {
            return;
        }
        int repeats = assignment.repeats();
        var start = new double[repeats];
        for (int count : new int[] {100, 1000}) {
            String name = pair.name(side.what("create." + count));
            Map<String, Program> agents = team(count, Program.BEGINNER);
            var seconds = new double[repeats];
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name, i, repeats);
                var watch = new Stopwatch();
                try (Team team = side.real.get()) {
                    start[i] = watch.wall();
                    team.platform.start(agents);
                    for (String agent : agents.keySet()) {
                        OverheadBench.until(() -> team.platform.count(agent) == 1);
                    }
                    seconds[i] = watch.wall() - start[i];
                }
            }
            assignment.report(Result.less(name, "s", seconds));
        }
        assignment.report(Result.less(pair.name(side.what("start")), "s", start));
    }

    private static void load(Pair pair, Side ours, Side theirs, BenchmarkRequest assignment) {
        if (!wants(
                assignment,
                pair,
                ours.what("load.cpu"),
                ours.what("load.rate"),
                theirs.what("load.cpu"),
                theirs.what("load.rate"),
                "written.overhead")) {
            return;
        }
        Map<String, Program> agents = team(HostBench.TEAM, Program.TELLER);
        List<String> all = List.copyOf(agents.keySet());
        int repeats = assignment.repeats();
        var written = new PlatformLoad[repeats];
        var bare = new PlatformLoad[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(pair.name("written.overhead"), i, repeats);
            written[i] = load(ours.real, agents, all);
            bare[i] = load(theirs.real, agents, all);
        }
        assignment.report(
                Result.less(pair.name(ours.what("load.cpu")), "core", each(written, PlatformLoad::cpu)),
                Result.more(pair.name(ours.what("load.rate")), "1/s", each(written, PlatformLoad::rate)),
                Result.less(pair.name(theirs.what("load.cpu")), "core", each(bare, PlatformLoad::cpu)),
                Result.more(pair.name(theirs.what("load.rate")), "1/s", each(bare, PlatformLoad::rate)),
                Result.less(pair.name("written.overhead"), "", ratios(written, bare)));
    }

    private static void contracts(Pair pair, Side ours, Side theirs, BenchmarkRequest assignment) {
        if (!wants(assignment, pair, ours.what("contracts"), theirs.what("contracts"), "written.overhead.contracts")) {
            return;
        }
        Map<String, Program> agents = team(HostBench.BIDDERS, Program.BIDDER);
        agents.put(MANAGER, Program.MANAGER);
        int repeats = assignment.repeats();
        var written = new PlatformLoad[repeats];
        var bare = new PlatformLoad[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(pair.name("written.overhead.contracts"), i, repeats);
            written[i] = load(ours.fast, agents, List.of(MANAGER));
            bare[i] = load(theirs.fast, agents, List.of(MANAGER));
        }
        assignment.report(
                Result.more(pair.name(ours.what("contracts")), "1/s", each(written, PlatformLoad::rate)),
                Result.more(pair.name(theirs.what("contracts")), "1/s", each(bare, PlatformLoad::rate)),
                Result.less(pair.name("written.overhead.contracts"), "", ratios(written, bare)));
    }

    private static void deliveries(Pair pair, Side side, BenchmarkRequest assignment) {
        if (!wants(assignment, pair, side.what("deliveries"))) {
            return;
        }
        String name = pair.name(side.what("deliveries"));
        Map<String, Program> agents = team(HostBench.TEAM, Program.TALKER);
        List<String> all = List.copyOf(agents.keySet());
        int repeats = assignment.repeats();
        var rate = new double[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(name, i, repeats);
            rate[i] = load(side.fast, agents, all).rate();
        }
        assignment.report(Result.more(name, "1/s", rate));
    }

    private static PlatformLoad load(Supplier<Team> begin, Map<String, Program> agents, List<String> counting) {
        try (Team team = begin.get()) {
            return team.load(agents, counting);
        }
    }

    private static double[] each(PlatformLoad[] loads, ToDoubleFunction<PlatformLoad> part) {
        return Stream.of(loads).mapToDouble(part).toArray();
    }

    private static double[] ratios(PlatformLoad[] ours, PlatformLoad[] theirs) {
        return IntStream.range(0, ours.length)
                .mapToDouble(i -> ours[i].each() / theirs[i].each())
                .toArray();
    }
}
