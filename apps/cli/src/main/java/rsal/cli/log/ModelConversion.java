package rsal.cli.log;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.cli.terminal.FileError;
import rsal.model.RobotModels;
import rsal.model.urdf.UrdfModel;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;

/// A robot model of a URDF file.
public final class ModelConversion implements Conversion {
    static final String URDF = ".urdf";

    /// @param files that were written, the model's first
    record Model(String file, List<String> files, List<FileError> notes) {}

    @Override
    public String description() {
        return "robot descriptions of ROS (ROBOT.urdf)";
    }

    @Override
    public boolean accepts(String file, Optional<String> out) {
        return file.endsWith(URDF);
    }

    @Override
    public Result convert(Request request) {
        Path target = ConvertedFiles.target(request, "\\.urdf$", ".yaml");
        String name = String.valueOf(target.getFileName()).replaceFirst("\\.yaml$", "");
        String text = FileSource.disk().text(request.file(), UrdfModel.MOST_CHARACTERS, Location.of(request.file()));
        UrdfModel made = UrdfModel.read(text, request.file(), name);
        var files = new ConvertedFiles();
        files.add(target, made.model().getBytes(StandardCharsets.UTF_8));
        made.parts()
                .forEach((part, yaml) -> files.add(target.resolveSibling(part), yaml.getBytes(StandardCharsets.UTF_8)));
        checkReadable(request.file(), name + ".yaml", files);
        files.write(request.force());
        var lines = new ArrayList<>(files.names());
        lines.add("%nIn a scenario: robots: {NAME: {model: %s}}.".formatted(name + ".yaml"));
        return new Result(
                new Model(request.file(), files.names(), FileError.of(made.notes())),
                lines,
                made.notes().stream().map(String::valueOf).toList());
    }

    /// What can't be read again is not worth writing.
    private static void checkReadable(String file, String name, ConvertedFiles files) {
        try {
            new RobotModels(files.source(), Map.of()).read(name, Location.of(name));
        } catch (InvalidSettings e) {
            throw new InvalidSettings(e.problems().stream()
                    .map(problem -> new Problem(
                            Location.of(file),
                            "No robot model can be made of this: " + problem.message(),
                            problem.remedy()))
                    .toList());
        }
    }
}
