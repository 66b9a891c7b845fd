package rsal.cli.run;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.page.Onlookers;
import rsal.cli.page.PageChoices;
import rsal.cli.page.PageRuns;
import rsal.cli.show.ScenarioReference;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.recording.Recorder;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.server.RunServer;

/// `rsal serve`
@Command(
        name = "serve",
        description = {
            "Show a page in which people choose a scenario and its settings, and start it.",
            "The address of the page is printed first. The page stays until Ctrl-C."
        })
public final class ServeCommand extends Subcommand {
    @Parameters(
            converter = FileName.class,
            paramLabel = "SCENARIO",
            arity = "0..*",
            description =
                    "Your scenarios, which the page offers, too: a file, its folder as for 'rsal run', or a world."
                            + " They are read again for each run. Anyone who has the address with its token can run"
                            + " these files, and no others.")
    private List<String> own = List.of();

    @Mixin
    private PageChoices page = new PageChoices();

    @Option(names = "--force", description = "Overwrite an existing recording.")
    private boolean force;

    @Override
    protected int run() throws Exception {
        own.forEach(Scenario::load); // errors are told now
        PageRuns.Endpoints endpoints = page.endpoints(spec.commandLine());
        Onlookers onlookers = page.onlookers(force, false, typed(), err());
        var first = PageRuns.First.of(waiting(), own, PageRuns.Stay.FOR_A_CHOICE, page.sweeps());
        return RunCommand.exit(PageRuns.show(first, endpoints, err(), eye(onlookers)));
    }

    /// What the page shows until somebody chooses: the first of a person's own, if its time can stand still.
    private RunPlan waiting() {
        return Stream.concat(own.stream(), Stream.of(ScenarioReference.DEFAULT))
                .map(name -> Scenario.load(name).plan(RunOptions.NONE))
                .filter(plan -> plan.clock() == RunPlan.Clock.SIMULATED)
                .findFirst()
                .orElseThrow();
    }

    private PageRuns.Eye eye(Onlookers onlookers) {
        return new PageRuns.Eye() {
            private volatile @Nullable LiveRun waiting;

            // that one is there to be looked at: it is not recorded, and its end is none to be told
            @Override
            public synchronized LiveRun start(RunPlan plan) {
                if (waiting != null) {
                    return onlookers.start(plan);
                }
                LiveRun run = LiveRun.start(plan);
                run.pause();
                run.step(); // for its robots to be seen
                waiting = run;
                return run;
            }

            @Override
            public boolean isWaiting(LiveRun run) {
                return run.equals(waiting);
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
            public void began(LiveRun run) {}

            @Override
            public void ended(LiveRun run, RunResult result) {
                if (!run.equals(waiting)) {
                    onlookers.end(run);
                    print(run.plan(), result);
                }
            }

            @Override
            public void close() {
                onlookers.close();
            }
        };
    }
}
