package rsal.scenario;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// The scenario of a folder that somebody named in place of its file.
final class ScenarioFolder {
    private static final int MOST_NAMED = 5; // files, in a message

    private ScenarioFolder() {}

    /// @throws InvalidSettings when there is none, with the files that are there
    static Path fileIn(Path folder) {
        Path name = folder.toAbsolutePath().normalize().getFileName();
        List<String> names =
                name == null ? List.of(Scenario.FILE) : List.of(Scenario.FILE, Scenario.fileIn(name.toString()));
        return names.stream()
                .map(folder::resolve)
                .filter(Files::exists)
                .findFirst()
                .orElseThrow(() -> new InvalidSettings(
                        Location.of(folder.toString()),
                        "There is no scenario in this folder: no '%s'.".formatted(String.join("' and no '", names)),
                        remedy(folder)));
    }

    private static String remedy(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            List<String> found = files.filter(file -> file.toString().endsWith(".yaml"))
                    .filter(file -> !Scenario.isWorld(file.toString()))
                    .map(file -> file.normalize().toString())
                    .sorted()
                    .limit(MOST_NAMED)
                    .toList();
            return found.isEmpty()
                    ? "Name the file of a scenario, or make one: rsal new NAME."
                    : "Maybe one of its files was meant: %s.".formatted(String.join(", ", found));
        } catch (IOException _) {
            return "Name the file of a scenario, FOLDER/FILE.yaml.";
        }
    }
}
