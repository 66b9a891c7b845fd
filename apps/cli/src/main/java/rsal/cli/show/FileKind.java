package rsal.cli.show;

import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import rsal.map.Maps;
import rsal.model.RobotModels;
import rsal.scenario.Scenario;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Value;
import rsal.yaml.Yaml;

/// What a name on the command line stands for, when that is neither a scenario nor a world: people name their maps and
/// models where a scenario is asked for.
enum FileKind {
    MAP("a map", "'rsal show %1$s' draws it. In a scenario: world: {map: %2$s}."),
    MODEL("a robot model", "'rsal show %1$s' shows it. In a scenario: robots: {NAME: {model: %2$s}}."),
    PART("a part of robots", "'rsal show %1$s' shows it. In a scenario: devices: {DEVICE: %2$s}."),
    WORLD("a world", "Names of worlds end with .world.yaml: rename it."),
    AGENT("an agent's program", "'rsal show %1$s' shows what is in it. In a scenario: agents: {NAME: {type: %2$s}}."),
    PLUGIN("a metric or a plugin", "'rsal show %1$s' shows what it is, and how a scenario names it."),
    RECORDING("a recording", "'rsal replay %1$s' plays it, 'rsal show %1$s' shows what is in it."),
    LOG("a log of a robot", Remedies.OF_LOGS),
    BAG("a bag of ROS 2", Remedies.OF_LOGS),
    IMAGE(
            "an image",
            "A map is a YAML file that names an image, its resolution and its origin, as ROS's map_server has it.");

    private static final String METADATA = "metadata.yaml";
    private static final String OF_BAGS = "rosbag2_bagfile_information";
    private static final int MOST_METADATA = 1_000_000; // bytes
    private static final Set<String> IMAGES =
            Set.of(".png", ".pgm", ".ppm", ".pbm", ".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff");
    private static final List<String> OF_SCENARIOS = List.of("scenario", "agents", "configurations", "run", "metrics");
    private static final List<String> OF_WORLDS = List.of("walls", "things", "fields", "models", "area", "onCollision");
    private static final List<String> OF_MODELS = List.of("body", "drive", "mounts", "sensors");
    private static final List<String> OF_MAPS =
            List.of("image", "drawing", "resolution", "origin", "mode", "negate", "occupied_thresh", "free_thresh");

    private final String words;
    private final String remedy;

    FileKind(String words, String remedy) {
        this.words = words;
        this.remedy = remedy;
    }

    /// `a map`.
    String words() {
        return words;
    }

    /// What constants can't refer to in their own class.
    private static final class Remedies {
        static final String OF_LOGS =
                "'rsal map %1$s --out DIR' makes a map of it, 'rsal localize %1$s --map MAP.yaml' localizes the robot, 'rsal convert %1$s OUT' converts it.";
    }

    /// @param name as typed
    /// @return empty for scenarios and worlds, and for what can't be told
    static Optional<FileKind> of(String name) {
        if (Scenario.builtInNames().contains(name) || Scenario.isWorld(name)) {
            return Optional.empty();
        }
        if (Maps.builtIn().contains(name)) {
            return Optional.of(MAP);
        }
        if (RobotModels.builtIn().contains(name)) {
            return Optional.of(MODEL);
        }
        if (RobotModels.builtInParts().contains(name)) {
            return Optional.of(PART);
        }
        if (isBag(name)) {
            return Optional.of(BAG);
        }
        if (OwnPlugin.is(name)) {
            return Optional.of(PLUGIN);
        }
        return name.endsWith(".yaml") || name.endsWith(".yml") ? written(name) : named(name.toLowerCase(Locale.ROOT));
    }

    private static boolean isBag(String name) {
        if (name.endsWith(".db3")) {
            return true;
        }
        try {
            return new File(name, METADATA).isFile()
                    && FileSource.folder(Path.of(name))
                            .text(METADATA, MOST_METADATA, Location.of(name))
                            .contains(OF_BAGS);
        } catch (InvalidSettings | InvalidPathException _) {
            return false; // too large for one, or not readable
        }
    }

    private static Optional<FileKind> named(String name) {
        if (RecordingFile.is(name)) {
            return Optional.of(RECORDING);
        }
        if (ShownAgent.is(name)) {
            return Optional.of(AGENT);
        }
        String unpacked = name.endsWith(".gz") ? name.substring(0, name.length() - 3) : name;
        if (IMAGES.stream().anyMatch(unpacked::endsWith)) {
            return Optional.of(IMAGE);
        }
        return unpacked.endsWith(".log") || unpacked.endsWith(".clf") ? Optional.of(LOG) : Optional.empty();
    }

    /// By the settings in a file; also where something is missing or wrong in it, which the next reader reports.
    private static Optional<FileKind> written(String name) {
        Value.Mapping file;
        try {
            file = Yaml.read(FileSource.disk(), name, Location.of(name));
        } catch (InvalidSettings _) {
            return Optional.empty();
        }
        Predicate<String> has = key -> file.find(key).isPresent();
        if (OF_SCENARIOS.stream().anyMatch(has)) {
            return Optional.empty();
        }
        if (OF_MAPS.stream().filter(has).count() > 1) {
            return Optional.of(MAP);
        }
        if (OF_MODELS.stream().filter(has).count() > 1) {
            return Optional.of(MODEL);
        }
        if (OF_WORLDS.stream().anyMatch(has)) {
            return Optional.of(WORLD);
        }
        return has.test("type") && !has.test("rsal") ? Optional.of(PART) : Optional.empty();
    }

    /// @throws InvalidSettings when a name stands for something else than a scenario or a world
    static void requireScenario(String name) {
        of(name).ifPresent(kind -> {
            throw kind.refusal(name);
        });
    }

    InvalidSettings refusal(String name) {
        return new InvalidSettings(
                Location.of(name),
                "This is %s, not a scenario.".formatted(words),
                remedy.formatted(name, name.substring(name.lastIndexOf('/') + 1)));
    }
}
