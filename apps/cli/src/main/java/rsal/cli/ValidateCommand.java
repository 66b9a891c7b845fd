package rsal.cli;

import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rsal.scenario.Scenario;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// `rsal validate`
@Command(
        name = "validate",
        description =
                "Check scenarios with all their configurations, and worlds, and tell every mistake. Starts nothing.")
final class ValidateCommand extends Subcommand {
    @Parameters(
            paramLabel = "FILE",
            arity = "1..*",
            description = "A file of a scenario or a world, or the name of a built-in scenario.")
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private List<String> files;

    /// Problems are flat, for those who read JSON line by line.
    record Checked(String file, boolean valid, List<Mistake> problems) {}

    record Mistake(String file, int line, int column, String message, String remedy) {
        static Mistake of(Problem problem) {
            return new Mistake(
                    problem.location().file(),
                    problem.location().line(),
                    problem.location().column(),
                    problem.message(),
                    problem.remedy());
        }
    }

    @Override
    int run() {
        List<Checked> checked = files.stream().map(this::check).toList();
        boolean valid = checked.stream().allMatch(Checked::valid);
        if (json) {
            printJson(Map.of("files", checked));
        }
        return valid ? Exit.SUCCESS : Exit.INVALID;
    }

    private Checked check(String file) {
        try {
            if (Scenario.isWorld(file) && Scenario.scene(file).robots().isEmpty()) {
                tell("%s: right, a world without robots".formatted(file));
                return new Checked(file, true, List.of());
            }
            Scenario scenario = Scenario.load(file);
            scenario.check();
            tell("%s: right, with %d configuration(s)"
                    .formatted(file, scenario.configurations().size()));
            return new Checked(file, true, List.of());
        } catch (InvalidSettings mistakes) {
            tell(String.valueOf(mistakes.getMessage()));
            return new Checked(
                    file, false, mistakes.problems().stream().map(Mistake::of).toList());
        }
    }

    private void tell(String text) {
        if (!json) {
            out().println(text);
            out().flush();
        }
    }
}
