package rsal.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.scenario.Counted;
import rsal.scenario.Scenario;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.world.yaml.SceneWriter;
import rsal.world.yaml.YamlFormat;

/// `rsal convert`
@Command(
        name = "convert",
        description = "Write a world of Stage as the same world in YAML, its floor plans as images beside it.")
final class ConvertCommand extends Subcommand {
    @Parameters(index = "0", paramLabel = "FILE.world", description = "The world's file.")
    private String file = "";

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "OUT" + YamlFormat.SUFFIX,
            description = "Where to write it; beside the world, when left out.")
    private @Nullable String out;

    @Option(names = "--force", description = "Overwrite files that are there.")
    private boolean force;

    /// @param files that were written, the world's first
    record Converted(String file, List<String> files, int things, int robots, List<ValidateCommand.Mistake> warnings) {}

    @Override
    int run() {
        if (!file.endsWith(".world")) {
            throw new InvalidSettings(
                    Location.of(file), "This is no world that can be converted.", "Those of Stage can: FILE.world.");
        }
        Path target = target();
        Scene scene = Scenario.scene(file);
        String name = String.valueOf(target.getFileName());
        var written = SceneWriter.write(scene, name.substring(0, name.length() - YamlFormat.SUFFIX.length()));
        var contents = new LinkedHashMap<Path, byte[]>();
        contents.put(target, written.yaml().getBytes(StandardCharsets.UTF_8));
        written.images().forEach((image, bytes) -> contents.put(target.resolveSibling(image), bytes));
        checkReadable(name, written);
        checkFree(contents);
        write(contents);
        tell(scene, contents);
        return Exit.SUCCESS;
    }

    private Path target() {
        try {
            Path target = Path.of(out != null ? out : file.replaceFirst("\\.world$", YamlFormat.SUFFIX));
            if (!target.toString().endsWith(YamlFormat.SUFFIX)) {
                throw new ParameterException(
                        spec.commandLine(),
                        "(%s) must end with %s, as worlds in YAML do.".formatted(target, YamlFormat.SUFFIX));
            }
            return target;
        } catch (InvalidPathException e) {
            throw new ParameterException(spec.commandLine(), "(%s) can't be a file.".formatted(out), e);
        }
    }

    /// What can't be read again is not worth writing.
    private void checkReadable(String name, SceneWriter.Written written) {
        try {
            new YamlFormat()
                    .read(
                            name,
                            (path, _, askedAt) -> {
                                byte[] image = path.equals(name)
                                        ? written.yaml().getBytes(StandardCharsets.UTF_8)
                                        : written.images().get(path);
                                if (image == null) {
                                    throw new InvalidSettings(askedAt, "There is no file (%s).".formatted(path), "");
                                }
                                return image;
                            },
                            0);
        } catch (InvalidSettings e) {
            List<String> lines = written.yaml().lines().toList();
            throw new InvalidSettings(e.problems().stream()
                    .map(problem -> new Problem(
                            Location.of(file),
                            "This can't be told in YAML: " + problem.message(),
                            where(problem.location(), lines)))
                    .toList());
        }
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
            throw new Unreachable("The world can't be written: %s.".formatted(e));
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
                    file,
                    files,
                    scene.things().size(),
                    scene.robots().size(),
                    ValidateCommand.Mistake.of(scene.warnings())));
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
