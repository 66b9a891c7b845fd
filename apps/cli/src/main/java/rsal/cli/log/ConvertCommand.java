package rsal.cli.log;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Mistake;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.model.RobotModels;
import rsal.model.urdf.UrdfModel;
import rsal.scenario.Scenario;
import rsal.scenario.text.Counted;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.world.SceneExport;
import rsal.world.yaml.SceneWriter;
import rsal.world.yaml.YamlFormat;

/// `rsal convert`
@Command(
        name = "convert",
        description =
                "Convert a world of Stage or Gazebo to YAML, with its floor plans as images beside it. Or convert any"
                        + " world or scenario for Gazebo (OUT.sdf), with its robots, and a configuration for ros_gz_bridge beside"
                        + " it. Or convert a robot description of ROS (URDF) to a robot model, with parts for its lasers beside"
                        + " it.")
public final class ConvertCommand extends Subcommand {
    @Parameters(
            index = "0",
            converter = FileName.class,
            paramLabel = "FILE.world|FILE.sdf|SCENARIO|ROBOT.urdf",
            description = "The file of the world or the robot; for Gazebo also a scenario. Expand a .xacro file first.")
    private String file = "";

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "OUT.yaml|OUT.sdf",
            description = "The file to write (for a world: OUT" + YamlFormat.SUFFIX + "; for Gazebo: OUT.sdf). Default:"
                    + " in YAML, beside the input file.")
    private @Nullable String out;

    @Option(names = "--force", description = "Overwrite existing files.")
    private boolean force;

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "For Gazebo: seed of the start poses, if a scenario draws them at random. Default: 1.")
    private long seed = 1;

    /// @param files that were written, the world's first
    record Converted(String file, List<String> files, int things, int robots, List<Mistake> warnings) {}

    /// @param files that were written, the model's first
    record Model(String file, List<String> files, List<Mistake> notes) {}

    @Override
    protected int run() {
        if (file.endsWith(".urdf")) {
            return model();
        }
        Optional<SceneExport> export = out == null ? Optional.empty() : SceneExport.of(out);
        if (export.isPresent()) {
            return export(export.get());
        }
        if (!file.endsWith(".world") && !file.endsWith(".sdf")) {
            throw new InvalidSettings(
                    Location.of(file),
                    "This is no file that can be converted.",
                    "Worlds of Stage (FILE.world) and Gazebo (FILE.sdf) can, and robot descriptions of ROS (ROBOT.urdf).");
        }
        Path target = target("\\.(world|sdf)$", YamlFormat.SUFFIX);
        Scene scene = Scenario.scene(file);
        String name = String.valueOf(target.getFileName());
        var written = SceneWriter.write(scene, name.substring(0, name.length() - YamlFormat.SUFFIX.length()));
        var contents = new LinkedHashMap<Path, byte[]>();
        contents.put(target, written.yaml().getBytes(StandardCharsets.UTF_8));
        written.images().forEach((image, bytes) -> contents.put(target.resolveSibling(image), bytes));
        checkReadable(name, written, contents);
        checkFree(contents);
        write(contents);
        tell(scene, contents);
        return Exit.SUCCESS;
    }

    /// The world of a file or a scenario for another program.
    private int export(SceneExport export) {
        Path target = target("$", export.suffix());
        String name = String.valueOf(target.getFileName());
        Scene scene = ExportedWorld.of(file, seed);
        var written = export.write(
                scene, name.substring(0, name.length() - export.suffix().length()), Location.of(file));
        var contents = new LinkedHashMap<Path, byte[]>();
        written.files().forEach((beside, bytes) -> contents.put(target.resolveSibling(beside), bytes));
        checkFree(contents);
        write(contents);
        if (json) {
            tell(scene, contents);
            return Exit.SUCCESS;
        }
        scene.warnings().forEach(warning -> err().println(warning));
        written.notes().forEach(note -> err().println("Note: " + note));
        contents.keySet().forEach(out()::println);
        out().println(written.summary());
        out().flush();
        return Exit.SUCCESS;
    }

    /// A robot model of a URDF file.
    private int model() {
        Path target = target("\\.urdf$", ".yaml");
        String name = String.valueOf(target.getFileName()).replaceFirst("\\.yaml$", "");
        String text = FileSource.disk().text(file, UrdfModel.MOST_CHARACTERS, Location.of(file));
        UrdfModel made = UrdfModel.read(text, file, name);
        var contents = new LinkedHashMap<Path, byte[]>();
        contents.put(target, made.model().getBytes(StandardCharsets.UTF_8));
        made.parts()
                .forEach((part, yaml) ->
                        contents.put(target.resolveSibling(part), yaml.getBytes(StandardCharsets.UTF_8)));
        checkModel(name + ".yaml", contents);
        checkFree(contents);
        write(contents);
        List<String> files = contents.keySet().stream().map(Path::toString).toList();
        if (json) {
            printJson(new Model(file, files, Mistake.of(made.notes())));
            return Exit.SUCCESS;
        }
        made.notes().forEach(note -> err().println(note));
        files.forEach(out()::println);
        out().println("%nIn a scenario: robots: {NAME: {model: %s}}.".formatted(name + ".yaml"));
        out().flush();
        return Exit.SUCCESS;
    }

    /// What can't be read again is not worth writing.
    private void checkModel(String name, Map<Path, byte[]> contents) {
        try {
            new RobotModels(files(contents), Map.of()).read(name, Location.of(name));
        } catch (InvalidSettings e) {
            throw new InvalidSettings(e.problems().stream()
                    .map(problem -> new Problem(
                            Location.of(file),
                            "No robot model can be made of this: " + problem.message(),
                            problem.remedy()))
                    .toList());
        }
    }

    /// @param ending of the file, a pattern
    /// @param wanted ending of what is written
    private Path target(String ending, String wanted) {
        try {
            Path target = Path.of(out != null ? out : file.replaceFirst(ending, wanted));
            if (!target.toString().endsWith(wanted)) {
                throw new ParameterException(spec.commandLine(), "'%s' must end with %s.".formatted(target, wanted));
            }
            return target;
        } catch (InvalidPathException e) {
            throw new ParameterException(spec.commandLine(), "'%s' can't be a file.".formatted(out), e);
        }
    }

    /// What can't be read again is not worth writing.
    private void checkReadable(String name, SceneWriter.Written written, Map<Path, byte[]> contents) {
        try {
            new YamlFormat().read(name, files(contents), 0);
        } catch (InvalidSettings e) {
            List<String> lines = written.yaml().lines().toList();
            throw new InvalidSettings(e.problems().stream()
                    .map(problem -> new Problem(
                            Location.of(file),
                            "This can't be written in YAML: " + problem.message(),
                            where(problem.location(), lines)))
                    .toList());
        }
    }

    /// What is to be written, by name, as if it were there.
    private static FileSource files(Map<Path, byte[]> contents) {
        return (path, _, askedAt) -> contents.entrySet().stream()
                .filter(file -> file.getKey().endsWith(path))
                .map(Map.Entry::getValue)
                .findFirst()
                .orElseThrow(() -> new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), ""));
    }

    /// What would have been written there.
    private static String where(Location location, List<String> lines) {
        return location.line() == 0
                ? ""
                : "It would be %s, which was not written: %s"
                        .formatted(location, lines.get(location.line() - 1).strip());
    }

    private void checkFree(Map<Path, byte[]> contents) {
        for (Path path : contents.keySet()) {
            Destination.require(Objects.requireNonNullElse(path.toAbsolutePath().getParent(), path));
            if (!force && Files.exists(path)) {
                throw new InvalidSettings(
                        Location.of(path.toString()), "This file is there already.", "Say --force to overwrite it.");
            }
        }
    }

    /// No file is left half written. What breaks while they are written changes none of them; as they are put in
    /// place one after the other, what breaks then may leave some new and others as they were.
    private static void write(Map<Path, byte[]> contents) {
        var parts = new LinkedHashMap<Path, Path>(); // by what they become
        try {
            for (Map.Entry<Path, byte[]> content : contents.entrySet()) {
                Path path = content.getKey();
                Path part = path.resolveSibling("." + path.getFileName() + ".part");
                parts.put(path, part);
                Files.write(part, content.getValue());
            }
            for (Map.Entry<Path, Path> part : parts.entrySet()) {
                Files.move(part.getValue(), part.getKey(), java.nio.file.StandardCopyOption.REPLACE_EXISTING);
            }
        } catch (IOException e) {
            throw new Unreachable("It can't be written: %s.".formatted(e));
        } finally {
            parts.values().forEach(ConvertCommand::deleteQuietly);
        }
    }

    private static void deleteQuietly(Path part) {
        try {
            Files.deleteIfExists(part);
        } catch (IOException _) {
            // there is nothing better to do
        }
    }

    private void tell(Scene scene, Map<Path, byte[]> contents) {
        List<String> files = contents.keySet().stream().map(Path::toString).toList();
        if (json) {
            printJson(new Converted(
                    file, files, scene.things().size(), scene.robots().size(), Mistake.of(scene.warnings())));
            return;
        }
        scene.warnings().forEach(warning -> err().println(warning));
        out().println("%s: %s, %s"
                .formatted(
                        files.getFirst(),
                        Counted.of(scene.things().size(), "thing"),
                        Counted.of(scene.robots().size(), "robot")));
        files.stream().skip(1).forEach(image -> out().println(image));
        out().flush();
    }
}
