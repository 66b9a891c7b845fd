package rsal.cli.run;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.TypeConversionException;
import rsal.cli.page.Onlookers;
import rsal.cli.page.PageChoices;
import rsal.cli.page.PageRuns;
import rsal.cli.show.ScenarioReference;
import rsal.cli.terminal.ClosedAtExit;
import rsal.cli.terminal.CommandWords;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Progress;
import rsal.cli.terminal.Subcommand;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.recording.Recorder;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.server.RunServer;

/// `rsal run`
@Command(
        name = "run",
        description = {
            "Run a scenario, and show it in a browser. With --headless, print only its result.",
            "The address of the page is printed first. The page stays until Ctrl-C or, with --once, until the run"
                    + " ends."
        })
public final class RunCommand extends Subcommand {
    private static final Map<String, Integer> EXIT_BY_OUTCOME =
            Map.of("success", Exit.SUCCESS, "failure", Exit.NO_SUCCESS, "timeout", Exit.NO_SUCCESS);

    @Parameters(
            converter = FileName.class,
            paramLabel = "SCENARIO[:CONFIGURATION]",
            arity = "0..1",
            defaultValue = ScenarioReference.DEFAULT,
            description = ScenarioReference.WHAT
                    + "; or a world (FILE.world.yaml, Stage's FILE.world, Gazebo's FILE.sdf, or Player's FILE.cfg)."
                    + " Default: ${DEFAULT-VALUE}.")
    private String scenario = "";

    @Mixin
    private RunChoices choices = new RunChoices();

    @Option(names = "--headless", description = "No page: the command ends with the run.")
    private boolean headless;

    @Option(names = "--quiet", description = "Do not print the lines of agents.")
    private boolean quiet;

    @Option(names = "--once", description = "With a page: end the command when the run ends.")
    private boolean once;

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            converter = Seconds.class,
            description = "End after this number of simulated seconds.")
    private @Nullable Duration limit;

    @Option(
            names = "--mas",
            paramLabel = "KEY",
            description = "Run the agents on another agent platform ('rsal list mas').")
    private @Nullable String mas;

    @Option(
            names = "--mrs",
            paramLabel = "KEY",
            description = "Take the robots from another robot system ('rsal list mrs').")
    private @Nullable String mrs;

    @Option(
            names = "--clock",
            paramLabel = "simulated|wall",
            description = "simulated: the same seed gives the same run. wall: real time, which some agent"
                    + " platforms and all real robots need.")
    private @Nullable String clock;

    @Option(
            names = "--with",
            converter = FileName.class,
            paramLabel = "SCENARIO[:CONFIGURATION]",
            description = "Let the agents without a robot of another scenario join, such as 'distribution:found',"
                    + " which distributes the robots repeatedly.")
    private @Nullable String with;

    @Mixin
    private PageChoices page = new PageChoices();

    @Option(
            names = "--save-maps",
            paramLabel = "DIR",
            description = "Write the maps that robots have drawn to this folder when the run ends: ROBOT.yaml and"
                    + " ROBOT.pgm.")
    private @Nullable String saveMaps;

    @Option(names = "--force", description = "Overwrite existing maps and recordings.")
    private boolean force;

    @Option(
            names = "--arm",
            description =
                    "Switch the motors on at the start. Without it, real robots stand until somebody arms them. It"
                            + " has no effect on a scenario that was edited in the page.")
    private boolean arm;

    @Override
    protected int run() throws Exception {
        ScenarioReference reference = ScenarioReference.parse(scenario);
        RunPlan plan = reference.load().plan(options(reference.configuration()));
        printNotes(plan);
        if (headless && plan.scenario().isWorld() && plan.stops().isEmpty() && limit == null) {
            throw new ParameterException(
                    spec.commandLine(), "A world has no stop condition: without a page, add --for SECONDS.");
        }
        if (headless && plan.startsDisarmed() && !arm) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Its robots stand until somebody switches their motors on: without a page, add --arm.");
        }
        Optional<SavedMaps> maps = Optional.ofNullable(saveMaps).map(folder -> SavedMaps.to(folder, plan, force));
        PageRuns.Endpoints endpoints = page.endpoints(spec.commandLine());
        check(!headless || endpoints.listening().isEmpty(), "--listen is for the page, which --headless leaves out.");
        Onlookers onlookers = page.onlookers(force, headless, typed(), err());
        RunResult result =
                headless ? runHeadless(plan, maps, onlookers) : runWithPage(plan, maps, onlookers, endpoints);
        int code = exit(result);
        return code == Exit.SUCCESS && onlookers.hasFailed() ? Exit.UNREACHABLE : code;
    }

    /// What a run's end means to those that started it.
    static int exit(RunResult result) {
        return EXIT_BY_OUTCOME.getOrDefault(result.outcome(), Exit.SUCCESS);
    }

    private RunResult runHeadless(RunPlan plan, Optional<SavedMaps> maps, Onlookers onlookers) throws Exception {
        var begun = new AtomicReference<AutoCloseable>(() -> {});
        // before it begins: a recording that was begun has to end, too
        var ending = new ClosedAtExit(() -> close(begun.get(), onlookers));
        try (onlookers;
                LiveRun run = onlookers.start(plan)) {
            begun.set(run);
            armIfWanted(run);
            RunResult result = new Progress(err(), quiet).await(run);
            ending.checkNoSignal();
            onlookers.end(run);
            maps.ifPresent(saved -> saved.write(run, err()));
            print(plan, result);
            return result;
        }
    }

    private void armIfWanted(LiveRun run) {
        if (arm) {
            run.operator().rearm();
        }
    }

    /// The maps of a later run take the place of those of an earlier one.
    private RunResult runWithPage(
            RunPlan plan, Optional<SavedMaps> maps, Onlookers onlookers, PageRuns.Endpoints endpoints)
            throws Exception {
        var first = PageRuns.First.of(
                plan,
                List.of(ScenarioReference.parse(scenario).nameOrFile()),
                once ? PageRuns.Stay.FOR_THE_FIRST : PageRuns.Stay.FOR_MORE,
                page.sweeps());
        return PageRuns.show(first, endpoints, err(), new PageRuns.Eye() {
            @Override
            public LiveRun start(RunPlan next) {
                return onlookers.start(next);
            }

            @Override
            public boolean quiet() {
                return quiet;
            }

            @Override
            public void shown(RunServer server) {
                onlookers.heed(server);
            }

            @Override
            public Optional<Recorder.Tally> recorded() {
                return onlookers.recorded();
            }

            @Override
            public void began(LiveRun run) {
                if (isMeant(run) && !run.plan().scenario().isEdited()) { // who typed it had read another text
                    armIfWanted(run);
                }
            }

            // what was typed is meant for that scenario, not for one that somebody chooses in the page later
            private boolean isMeant(LiveRun run) {
                return run.plan().scenario().location().equals(plan.scenario().location());
            }

            @Override
            public void ended(LiveRun run, RunResult result) {
                onlookers.end(run);
                maps.filter(_ -> isMeant(run)).ifPresent(saved -> saved.write(run, err()));
                print(run.plan(), result);
            }

            @Override
            public void close() {
                onlookers.close();
            }
        });
    }

    private static void close(AutoCloseable run, Onlookers onlookers) throws Exception {
        run.close(); // first, for its end to be recorded
        onlookers.close();
    }

    private RunOptions options(Optional<String> configuration) {
        return new RunOptions(
                configuration,
                choices.arguments(),
                choices.seed(),
                Optional.ofNullable(mas),
                Optional.ofNullable(mrs),
                Optional.ofNullable(clock),
                Optional.ofNullable(with),
                Optional.ofNullable(limit),
                choices.speed());
    }

    public static final class Seconds implements ITypeConverter<Duration> {
        private static final double MOST = 1e9; // 31 years

        @Override
        public Duration convert(String typed) {
            double seconds = CommandWords.orNaN(typed);
            if (!(seconds > 0 && seconds <= MOST)) {
                throw new TypeConversionException("'%s' is not a number of seconds above 0, like 60.".formatted(typed));
            }
            return Duration.ofNanos(Math.round(seconds * 1e9));
        }
    }
}
