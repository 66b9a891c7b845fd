package rsal.cli.run;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.TypeConversionException;
import rsal.cli.page.PageChoices;
import rsal.cli.page.PageRuns;
import rsal.cli.show.ScenarioReference;
import rsal.cli.terminal.ClosedAtExit;
import rsal.cli.terminal.CommandWords;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Progress;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.cli.terminal.Unreachable;
import rsal.engine.LiveRun;
import rsal.engine.report.Answer;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.installed.Providers;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;
import rsal.settings.Suggestion;
import rsal.system.BridgeProvider;
import rsal.system.ExportedDevice;

/// `rsal bridge`
@Command(
        name = "bridge",
        description = {
            "Run a scenario or a world, and let programs of another system drive its robots.",
            "'rsal bridge player WORLD' serves them to clients of Player. 'rsal bridge player FILE.cfg' serves"
                    + " the devices of this configuration. 'rsal bridge ros2 SCENARIO' publishes them to"
                    + " programs of ROS 2. The command continues until the run ends, or until Ctrl-C."
        })
public final class BridgeCommand extends Subcommand {
    @Parameters(
            index = "0",
            paramLabel = "PROTOCOL",
            description = "One of those that 'rsal list bridges' names: player; player-3.0 for programs that were built"
                    + " for Player 3.0; ros2 for programs of ROS 2")
    private String key = "";

    @Parameters(
            index = "1",
            converter = FileName.class,
            paramLabel = "SCENARIO[:CONFIGURATION]",
            arity = "0..1",
            defaultValue = ScenarioReference.DEFAULT,
            description = "A scenario or the file of a world, as for 'rsal run'. Default: ${DEFAULT-VALUE}.")
    private String scenario = "";

    @Mixin
    private RunChoices choices = new RunChoices();

    @Option(
            names = "--port",
            paramLabel = "P",
            converter = PageChoices.Port.class,
            description =
                    "Port of the first robot; the others follow. 0: any free ports, not for ros2. Default: the usual"
                            + " port of the protocol (player: 6665). With a FILE.cfg, its ports are shifted by the same"
                            + " number. For ros2, it is the port of a domain, 7400 + 250 times its number; default: that"
                            + " of ROS_DOMAIN_ID.")
    private @Nullable Integer port;

    @Option(
            names = "--listen",
            paramLabel = "ADDRESS",
            description = "Address of this machine at which other machines reach the bridge, or 0.0.0.0 for all."
                    + " Default: this machine only.")
    private @Nullable String listen;

    @Option(
            names = "--page",
            description = "Also show the run in a page. If another run is started there, the bridge serves the robots"
                    + " of that run instead.")
    private boolean page;

    @Option(
            names = "--command-timeout",
            paramLabel = "S|off",
            defaultValue = "0.5",
            converter = Timeout.Converter.class,
            description = "Robots stop after this time without a command of a client [s] (${DEFAULT-VALUE}). 'off': a"
                    + " velocity is valid until the next one, for clients that send it only once. With"
                    + " --pace subscribers, it is simulated time while the run waits for programs.")
    private Timeout timeout = new Timeout(Optional.empty());

    @Option(
            names = "--no-agents",
            description = "Run without the scenario's agents and stop conditions: only the programs drive the robots.")
    private boolean noAgents;

    @Option(
            names = "--pace",
            paramLabel = "real-time|subscribers",
            defaultValue = "real-time",
            converter = Pace.Converter.class,
            description = "How simulated time goes on. real-time: at --speed times real time. subscribers (ros2 only):"
                    + " it waits for programs that publish '/clock_reached' or subscribe to '/clock' as reliable, and"
                    + " is at most --speed times real time (default: max). As long as there is no such program, it is"
                    + " real time at most. Default: ${DEFAULT-VALUE}.")
    private Pace pace = Pace.REAL_TIME;

    enum Pace {
        REAL_TIME("real-time"),
        SUBSCRIBERS("subscribers");

        private final String word;

        Pace(String word) {
            this.word = word;
        }

        static final class Converter implements ITypeConverter<Pace> {
            @Override
            public Pace convert(String typed) {
                return Arrays.stream(values())
                        .filter(each -> each.word.equals(typed))
                        .findFirst()
                        .orElseThrow(() -> new TypeConversionException(
                                "'%s' is neither real-time nor subscribers.".formatted(typed)));
            }
        }
    }

    /// @param limit empty when there is none
    record Timeout(Optional<Duration> limit) {
        static final class Converter implements ITypeConverter<Timeout> {
            @Override
            public Timeout convert(String typed) {
                if (typed.equals("off")) {
                    return new Timeout(Optional.empty());
                }
                double seconds = CommandWords.orNaN(typed);
                if (!(seconds >= 0.2 && seconds <= 3600)) {
                    throw new TypeConversionException(
                            "'%s' is not a number of seconds from 0.2 to 3600, nor 'off'.".formatted(typed));
                }
                return new Timeout(Optional.of(Duration.ofMillis(Math.round(1000 * seconds))));
            }
        }
    }

    @Override
    protected int run() throws Exception {
        BridgeProvider provider = provider();
        InetSocketAddress at = address(port == null ? provider.defaultPort() : port);
        ScenarioReference reference = ScenarioReference.parse(scenario);
        RunPlan asked = reference.load().plan(options(reference.configuration()));
        RunPlan plan = noAgents ? asked.unmanned() : asked;
        checkServices(plan);
        checkPace(provider, plan);
        printNotes(plan);
        return RunCommand.exit(page ? runWithPage(plan, provider, at) : run(plan, provider, at));
    }

    private RunResult run(RunPlan plan, BridgeProvider provider, InetSocketAddress at) throws Exception {
        try (LiveRun run = start(plan)) {
            var ending = new ClosedAtExit(run);
            offer(run, provider, at);
            RunResult result = new Progress(err(), false).await(run);
            ending.checkNoSignal();
            printResult(plan, result);
            return result;
        }
    }

    private RunResult runWithPage(RunPlan plan, BridgeProvider provider, InetSocketAddress at) throws Exception {
        return PageRuns.show(PageRuns.First.alone(plan), PageRuns.Endpoints.USUAL, err(), new PageRuns.Eye() {
            @Override
            public LiveRun start(RunPlan wanted) {
                return BridgeCommand.this.start(wanted);
            }

            @Override
            public void began(LiveRun run) throws Exception {
                offer(run, provider, at);
            }

            @Override
            public void ended(LiveRun run, RunResult result) {
                printResult(run.plan(), result);
            }
        });
    }

    /// One that goes as fast as programs follow is to wait for its bridge.
    private LiveRun start(RunPlan plan) {
        return isPaced(plan) ? LiveRun.of(plan).paused().start() : LiveRun.start(plan);
    }

    /// Also of runs that were started in the page.
    private boolean isPaced(RunPlan plan) {
        return isPaced() && plan.clock() == RunPlan.Clock.SIMULATED;
    }

    private void offer(LiveRun run, BridgeProvider provider, InetSocketAddress at) throws Exception {
        boolean paced = isPaced(run.plan());
        if (isPaced() && !paced) {
            err().println("This run goes in real time, so it does not wait for programs.");
        }
        printAnswer(
                provider,
                at,
                run.operator()
                        .bridge(provider, at, timeout.limit(), paced)
                        .toCompletableFuture()
                        .get());
        if (paced) {
            run.speed(choices.speed().orElse(Double.POSITIVE_INFINITY));
            run.resume();
        }
    }

    private void printResult(RunPlan plan, RunResult result) {
        if (!json) { // that is what was offered
            print(plan, result);
        }
    }

    /// @throws InvalidSettings when its world's file asks for something that can't be offered
    private static void checkServices(RunPlan plan) {
        List<Problem> refusals = plan.scene().services().stream()
                .flatMap(service -> service.refusal().stream())
                .distinct()
                .toList();
        if (!refusals.isEmpty()) {
            throw new InvalidSettings(refusals);
        }
    }

    private boolean isPaced() {
        return pace == Pace.SUBSCRIBERS;
    }

    private void checkPace(BridgeProvider provider, RunPlan plan) {
        if (isPaced() && !provider.canPace()) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Programs of '%s' can't pace a simulation. Leave '--pace' out, or use 'ros2'.".formatted(key));
        }
        if (isPaced() && plan.clock() == RunPlan.Clock.WALL) {
            throw new ParameterException(
                    spec.commandLine(),
                    "'--pace subscribers' needs simulated time, but this configuration runs in real time. Leave it out.");
        }
    }

    private BridgeProvider provider() {
        Map<String, BridgeProvider> all = Providers.byKey(BridgeProvider.class, BridgeProvider::key);
        BridgeProvider provider = all.get(key);
        if (provider == null) {
            throw new ParameterException(
                    spec.commandLine(),
                    "There is no bridge '%s'. %s".formatted(key, Suggestion.among(key, all.keySet())));
        }
        return provider;
    }

    private InetSocketAddress address(int number) {
        if (listen == null) {
            return new InetSocketAddress(InetAddress.getLoopbackAddress(), number);
        }
        try {
            var at = new InetSocketAddress(InetAddress.getByName(listen), number);
            if (!at.getAddress().isLoopbackAddress()) {
                err().println("Anyone who can reach this machine at " + listen
                        + " can drive these robots: the protocol knows no passwords.");
            }
            return at;
        } catch (UnknownHostException e) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Invalid value for option '--listen': '%s' is not an address of a machine, like 0.0.0.0."
                            .formatted(listen));
        }
    }

    private void printAnswer(BridgeProvider provider, InetSocketAddress at, Answer answer) {
        switch (answer) {
            case Answer.Bridged(List<ExportedDevice> offers) -> {
                if (json) {
                    var object = new LinkedHashMap<String, Object>();
                    object.put("protocol", key);
                    object.put("offers", offers);
                    printJson(object);
                    return;
                }
                out().println("Robots are at %s:".formatted(at.getHostString()));
                var table = new TextTable("  ");
                offers.forEach(offer -> table.row(offer.port() + ":" + offer.name(), offer.device()));
                out().print(table);
                out().flush();
            }
            case Answer.Refused(String why) ->
                throw new Unreachable(why + System.lineSeparator() + "    " + provider.portRemedy());
            default -> throw new AssertionError(answer);
        }
    }

    private RunOptions options(Optional<String> configuration) {
        return new RunOptions(
                configuration,
                choices.arguments(),
                choices.seed(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                isPaced() && choices.speed().isEmpty() ? OptionalDouble.of(Double.POSITIVE_INFINITY) : choices.speed());
    }
}
