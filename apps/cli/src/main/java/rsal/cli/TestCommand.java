package rsal.cli;

import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;

/// Listed here for the help; the launcher does it, because it builds what it tests.
@Command(name = "test", description = "Build everything and run all tests, including those of the page in a browser.")
final class TestCommand extends Subcommand {
    @Parameters(
            paramLabel = "TEST",
            arity = "0..*",
            description = "Run only these tests, without checks and within seconds: a class such as ContractNetTest, or"
                    + " CLASS#METHOD.")
    private List<String> tests = List.of();

    @Option(names = "--all", description = "Also run long tests: all seeds, comparisons over many runs.")
    private boolean all;

    @Option(
            names = "--mutation",
            description = "Only do mutation testing: change the code at one place at a time, and count the changes"
                    + " that tests notice. This takes a long time.")
    private boolean mutation;

    @Override
    protected int run() {
        throw new Unreachable("Tests are run by the launcher in the project's folder: ./rsal test"
                + (all ? " --all" : "")
                + (mutation ? " --mutation" : "")
                + tests.stream().map(test -> " " + test).collect(Collectors.joining()));
    }
}
