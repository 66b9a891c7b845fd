package rsal.cli;

import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.recording.Recorder;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.scenario.run.LiveRun;
import rsal.scenario.run.RunResult;

/// `rsal serve`
@Command(
        name = "serve",
        description = {
            "Show a page where people choose a scenario, what it is run with, and start it.",
            "The page's address is printed first; it stays until Ctrl-C."
        })
final class ServeCommand extends Subcommand {
    @Parameters(
            paramLabel = "SCENARIO",
            arity = "0..*",
            description =
                    "Scenarios of your own (a file, its folder, or a world) to be offered, too, read anew for each run:"
                            + " whoever has the page can run these, and no other files.")
    private List<String> own = List.of();

    @Mixin
    private PageChoices page = new PageChoices();

    @Option(names = "--force", description = "Overwrite a recording that is there.")
    private boolean force;

    @Override
    int run() throws Exception {
        own.forEach(Scenario::load); // mistakes are told now
        RunPlan first = Scenario.load(own.isEmpty() ? ScenarioReference.DEFAULT : own.getFirst())
                .plan(RunOptions.NONE);
        Onlookers onlookers = page.onlookers(force, false, typed(), err());
        RunResult result = PageRuns.show(
                new PageRuns.First(first, own, PageRuns.Stay.FOR_A_CHOICE), page.port(), err(), eye(onlookers));
        return RunCommand.exit(result);
    }

    private PageRuns.Eye eye(Onlookers onlookers) {
        return new PageRuns.Eye() {
            private boolean hasBegun;

            // the first waits for somebody who wants it, or another
            @Override
            public synchronized LiveRun start(RunPlan plan) {
                LiveRun run = onlookers.start(plan);
                if (!hasBegun) {
                    run.pause();
                    run.step(); // for its robots to be seen
                    hasBegun = true;
                }
                return run;
            }

            @Override
            public Optional<Recorder.Tally> recorded() {
                return onlookers.recorded();
            }

            @Override
            public void began(LiveRun run) {}

            @Override
            public void ended(LiveRun run, RunResult result) {
                onlookers.end(run);
                print(run.plan(), result);
            }

            @Override
            public void close() {
                onlookers.close();
            }
        };
    }
}
