package rsal.stage.playercfg;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.scene.RobotService;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.stage.StageFormat;
import rsal.stage.StageWorld;
import rsal.stage.WorldFiles;
import rsal.stage.WorldProblems;
import rsal.world.SceneFormat;

/// Configuration files of Player servers (`.cfg`): the world is the one of their `stage` driver, with what is
/// served of it. One without that driver has an empty world.
public final class PlayerFormat implements SceneFormat {
    private static final int MAX_WORLD = 1 << 24; // bytes

    @Override
    public String suffix() {
        return ".cfg";
    }

    @Override
    public Scene read(String path, FileSource files, long seed) {
        WorldFiles found = StageFormat.files(files);
        var findings = new WorldProblems();
        PlayerConfig config = PlayerConfig.read(path, found, findings);
        Optional<Driver.Option> worldFile = worldFile(config, findings);
        findings.throwIfAny();
        Scene scene;
        List<RobotService> services;
        if (worldFile.isPresent()) {
            String world = find(worldFile.get(), path, found);
            StageWorld read = StageWorld.read(world, found);
            services = new ServedDevices(config, read, findings).services();
            findings.throwIfAny();
            scene = StageFormat.scene(read, world, seed);
        } else {
            findings.warn(
                    Location.of(path),
                    "No driver 'stage' of it has a 'worldfile': the world is empty.",
                    "Maybe it goes with another file, which has one.");
            var empty = new StageWorld(path, Duration.ofMillis(100), 0.02, Optional.empty(), List.of(), List.of());
            services = new ServedDevices(config, empty, findings).services();
            scene = StageFormat.scene(empty, path, seed);
        }
        Optional<OccupancyGrid> map = new MapFile(config, found, findings).read();
        var warnings = new ArrayList<>(findings.warnings(path));
        warnings.addAll(scene.warnings());
        return map.map(scene::known).orElse(scene).serving(services, warnings);
    }

    /// What the first driver that simulates names.
    private static Optional<Driver.Option> worldFile(PlayerConfig config, WorldProblems findings) {
        Driver.Option world = null;
        boolean plugin = false;
        boolean any = false;
        for (Driver driver : config.drivers()) {
            if (!driver.name().equals(KnownDrivers.STAGE)) {
                continue;
            }
            any = true;
            plugin |= driver.plugin().isPresent();
            checkInterfaces(driver, findings);
            Driver.Option named = driver.option("worldfile").orElse(null);
            if (named != null && world != null) {
                findings.warn(
                        named.location(),
                        "This 'worldfile' has no effect: the first one counts, at %s.".formatted(world.location()),
                        "One server simulates one world.");
            } else if (named != null) {
                world = named;
            } else if (world == null) {
                findings.error(
                        driver.location(),
                        provides(driver, Interfaces.SIMULATION)
                                ? "This 'stage' names no 'worldfile'."
                                : "No 'stage' before this one has a 'worldfile'.",
                        provides(driver, Interfaces.SIMULATION)
                                ? "Write worldfile \"FILE.world\"."
                                : "Put driver ( name \"stage\" provides [ \"simulation:0\" ] worldfile \"FILE.world\" )"
                                        + " first.");
            }
        }
        if (any && !plugin) {
            findings.warn(
                    Location.of(config.path()),
                    "No driver 'stage' names its 'plugin'; Player would not find it.",
                    "Write plugin \"stageplugin\" in the first one.");
        }
        return Optional.ofNullable(world);
    }

    private static boolean provides(Driver driver, String type) {
        return driver.provides().stream().anyMatch(address -> address.type().equals(type));
    }

    private static void checkInterfaces(Driver driver, WorldProblems findings) {
        for (DriverAddress address : driver.provides()) {
            boolean known = Interfaces.MODELS.containsKey(address.type())
                    || Interfaces.OF_ANY_MODEL.contains(address.type())
                    || address.type().equals(Interfaces.SIMULATION);
            if (!known) {
                findings.error(
                        address.location(),
                        "Stage does not serve the interface '%s'.".formatted(address.type()),
                        Interfaces.DROPPED.getOrDefault(address.type(), "Remove it."));
            }
        }
    }

    private static String find(Driver.Option option, String config, WorldFiles files) {
        Optional<String> name = ConfigReader.text(option.value()).filter(text -> !text.isBlank());
        if (name.isEmpty()) {
            throw new InvalidSettings(
                    option.location(), "'worldfile' names no file.", "Write worldfile \"FILE.world\".");
        }
        return files.find(name.get(), config, MAX_WORLD, option.location()).path();
    }
}
