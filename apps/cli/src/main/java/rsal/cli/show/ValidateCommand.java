package rsal.cli.show;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileError;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.map.Maps;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// `rsal validate`
@Command(
        name = "validate",
        description = "Check scenarios with all configurations or with one, worlds, maps, robot models, parts, agents'"
                + " programs, metrics, controllers and recordings. Reports every error and starts nothing.")
public final class ValidateCommand extends Subcommand {
    @Parameters(
            converter = FileName.class,
            paramLabel = "SCENARIO[:CONFIGURATION]|FILE",
            arity = "1..*",
            description =
                    ScenarioReference.WHAT
                            + "; or the file of a world, a map, a robot model or part, an agent's program, a metric, a controller, or a recording.")
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private List<String> files;

    /// Problems are flat, for those who read JSON line by line.
    ///
    /// @param problems errors, or warnings when it is valid all the same
    /// @param besides what of a file with errors is only warned of
    record Checked(String file, boolean valid, List<FileError> problems, List<FileError> besides) {
        /// @param warnings what is only warned of
        static Checked right(String file, List<Problem> warnings) {
            return new Checked(file, true, FileError.of(warnings), List.of());
        }

        static Checked wrong(String file, InvalidSettings why) {
            return new Checked(file, false, FileError.of(why.problems()), FileError.of(why.warnings()));
        }
    }

    @Override
    protected int run() {
        List<Checked> checked = files.stream().map(this::check).toList();
        boolean valid = checked.stream().allMatch(Checked::valid);
        if (json) {
            printJson(Map.of("files", checked));
        }
        return valid ? Exit.SUCCESS : Exit.INVALID;
    }

    private Checked check(String file) {
        try {
            Optional<FileKind> other = FileKind.of(file);
            return other.isPresent()
                    ? checkOther(file, other.get())
                    : Scenario.isWorld(file) ? checkWorld(file) : checkScenario(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InvalidSettings errors) {
            print(String.valueOf(errors.getMessage()));
            return Checked.wrong(file, errors);
        }
    }

    private Checked checkScenario(String file) {
        ScenarioReference reference = ScenarioReference.parse(file);
        Scenario scenario = reference.load();
        var found = new LinkedHashSet<Problem>();
        if (reference.configuration().isPresent()) {
            RunPlan plan = scenario.plan(
                    RunOptions.NONE.withConfiguration(reference.configuration().get()));
            found.addAll(plan.scene().warnings());
            found.addAll(plan.notes());
            print(file + ": valid");
        } else {
            scenario.check(plan -> {
                found.addAll(plan.scene().warnings());
                found.addAll(plan.notes());
            });
            int configurations = scenario.configurations().size();
            print("%s: valid, %d configuration%s".formatted(file, configurations, configurations == 1 ? "" : "s"));
        }
        var notes = List.copyOf(found);
        notes.forEach(note -> print(FileError.note(note)));
        return Checked.right(file, notes);
    }

    private Checked checkOther(String file, FileKind kind) throws IOException {
        List<Problem> warnings = List.of();
        String what = kind.words();
        switch (kind) {
            case MAP -> {
                Maps.Found map = ShownMap.find(file);
                warnings = map.warnings();
                what += ", " + ShownMap.of(file, map).size();
            }
            case MODEL, PART ->
                what += ShownPart.of(file).map(shown -> ", " + shown.title()).orElse("");
            case AGENT -> ShownAgent.of(file);
            case PLUGIN -> what = OwnPlugin.of(file).map(InstalledKind::title).orElse(what);
            case RECORDING -> RecordingFile.open(file, true).close();
            case LOG, BAG, IMAGE, WORLD -> throw kind.refusal(file);
        }
        print("%s: valid, %s".formatted(file, what));
        warnings.forEach(warning -> print(FileError.note(warning)));
        return Checked.right(file, warnings);
    }

    /// Warnings are no errors, but nobody should miss them.
    private Checked checkWorld(String file) {
        Scene scene = Scenario.scene(file);
        if (!scene.robots().isEmpty()) {
            Scenario.load(file).check();
        }
        print("%s: valid, a world with %s"
                .formatted(
                        file,
                        switch (scene.robots().size()) {
                            case 0 -> "no robots";
                            case 1 -> "1 robot";
                            default -> scene.robots().size() + " robots";
                        }));
        scene.warnings().forEach(warning -> print(ShownWorld.line(warning)));
        return Checked.right(file, scene.warnings());
    }

    private void print(String text) {
        if (!json) {
            out().println(text);
            out().flush();
        }
    }
}
