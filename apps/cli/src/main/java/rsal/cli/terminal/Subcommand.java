package rsal.cli.terminal;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import rsal.engine.report.RunResult;
import rsal.scenario.RunPlan;
import tools.jackson.databind.MapperFeature;
import tools.jackson.databind.json.JsonMapper;

/// What all commands have in common: results go to stdout, as text for people or as JSON, all else to stderr.
public abstract class Subcommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    protected CommandSpec spec;

    @Option(names = "--json", description = "Print the result as one JSON object.")
    protected boolean json;

    @Option(names = "--debug", description = "Log more, and show where internal errors come from.")
    boolean debug;

    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this help.")
    boolean help;

    /// @return the exit code
    protected abstract int run() throws Exception;

    @Override
    public final Integer call() throws Exception {
        if (debug) {
            Logging.printMore();
        }
        return run();
    }

    /// @throws ParameterException unless it is right; the message names the option and its value
    protected final void check(boolean right, String message) {
        if (!right) {
            throw new ParameterException(spec.commandLine(), message);
        }
    }

    /// Tells what of a run may not be meant.
    protected final void printNotes(RunPlan plan) {
        plan.scene().warnings().forEach(warning -> err().println(warning));
        plan.notes().forEach(note -> err().println(FileError.note(note)));
    }

    /// The command as it was typed.
    protected final String typed() {
        return "rsal "
                + String.join(
                        " ", spec.commandLine().getParent().getParseResult().originalArgs());
    }

    protected final void print(RunPlan plan, RunResult result) {
        if (json) {
            printJson(ResultJson.of(plan, result));
        } else {
            out().print(new ResultText(plan, result));
            out().flush();
        }
    }

    protected final PrintWriter out() {
        return spec.commandLine().getOut();
    }

    protected final PrintWriter err() {
        return spec.commandLine().getErr();
    }

    /// Prints a result of maps, lists, records and values as JSON, on one line.
    protected final void printJson(Object result) {
        JsonMapper mapper = JsonMapper.builder()
                .disable(MapperFeature.SORT_PROPERTIES_ALPHABETICALLY)
                .build();
        out().println(mapper.writeValueAsString(result));
        out().flush();
    }
}
