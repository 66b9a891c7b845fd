package rsal.cli.log;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.cli.terminal.FileError;
import rsal.scenario.Scenario;
import rsal.scenario.text.Counted;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.world.SceneExport;
import rsal.world.yaml.SceneWriter;
import rsal.world.yaml.YamlFormat;

/// A world of Stage or Gazebo, in YAML.
public final class WorldConversion implements Conversion {
    private static final List<String> WORLDS = List.of(".world", ".sdf");

    /// @param files that were written, the world's first
    record Converted(String file, List<String> files, int things, int robots, List<FileError> warnings) {
        static Converted of(String file, ConvertedFiles written, Scene scene) {
            return new Converted(
                    file,
                    written.names(),
                    scene.things().size(),
                    scene.robots().size(),
                    FileError.of(scene.warnings()));
        }
    }

    @Override
    public String description() {
        return "worlds of Stage (FILE.world) and Gazebo (FILE.sdf)";
    }

    @Override
    public boolean accepts(String file, Optional<String> out) {
        return WORLDS.stream().anyMatch(file::endsWith)
                && out.flatMap(SceneExport::of).isEmpty();
    }

    @Override
    public Result convert(Request request) {
        Path target = ConvertedFiles.target(request, "\\.(world|sdf)$", YamlFormat.SUFFIX);
        Scene scene = Scenario.scene(request.file());
        String name = String.valueOf(target.getFileName());
        var written = SceneWriter.write(scene, name.substring(0, name.length() - YamlFormat.SUFFIX.length()));
        var files = new ConvertedFiles();
        files.add(target, written.yaml().getBytes(StandardCharsets.UTF_8));
        written.images().forEach((image, bytes) -> files.add(target.resolveSibling(image), bytes));
        checkReadable(request.file(), name, written, files);
        files.write(request.force());
        var lines = new ArrayList<String>();
        lines.add("%s: %s, %s"
                .formatted(
                        target,
                        Counted.of(scene.things().size(), "thing"),
                        Counted.of(scene.robots().size(), "robot")));
        files.names().stream().skip(1).forEach(lines::add);
        return new Result(
                Converted.of(request.file(), files, scene),
                lines,
                scene.warnings().stream().map(String::valueOf).toList());
    }

    /// What can't be read again is not worth writing.
    private static void checkReadable(String file, String name, SceneWriter.Written written, ConvertedFiles files) {
        try {
            new YamlFormat().read(name, files.source(), 0);
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

    /// What would have been written there.
    private static String where(Location location, List<String> lines) {
        return location.line() == 0
                ? ""
                : "It would be %s, which was not written: %s"
                        .formatted(location, lines.get(location.line() - 1).strip());
    }
}
