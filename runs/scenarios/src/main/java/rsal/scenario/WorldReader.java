package rsal.scenario;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.map.Maps;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scenario.RobotReader.Role;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.installed.Catalog;
import rsal.scenario.installed.MapFacts;
import rsal.scene.RobotService;
import rsal.scene.Scene;
import rsal.scene.Touch;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.world.SceneFormat;

/// Reads where a scenario takes place: a map, or the file of a world with all that is in it.
final class WorldReader {
    private static final int MAX_BYTES = 1 << 28;

    private final Catalog catalog;
    private final Maps maps;
    private final MapFacts mapFacts;
    private final DeviceSelector outfitter;
    private final FileSource files;
    private final Seeds seeds;
    private final Problems problems;

    WorldReader(Catalog catalog, Maps maps, MapFacts mapFacts, FileSource files, Seeds seeds, Problems problems) {
        this.catalog = catalog;
        this.maps = maps;
        this.mapFacts = mapFacts;
        this.outfitter = new DeviceSelector(catalog, seeds);
        this.files = files;
        this.seeds = seeds;
        this.problems = problems;
    }

    /// @param name as the scenario calls it
    /// @param scene empty when it can't be read
    record World(String name, Optional<Scene> scene) {}

    World read(Section world) {
        boolean map = world.has("map");
        boolean file = world.has("file");
        if (map == file) {
            world.done();
            problems.add(
                    world.location(),
                    map ? "'world' has both a 'map' and a 'file'." : "'world.map' is missing, or 'world.file'.",
                    "Write {map: office}, or {file: hall.world.yaml}.");
            return new World("", Optional.empty());
        }
        String name = world.text(map ? "map" : "file");
        Location at = world.locationOf(map ? "map" : "file");
        Optional<Touch> touch = touch(world);
        world.done();
        if (name.isEmpty()) {
            return new World("", Optional.empty());
        }
        try {
            Scene read = map ? mapped(maps.find(name, at)) : scene(name, at);
            Scene scene = touch.map(read::with).orElse(read);
            scene.warnings().forEach(problems::warn);
            return new World(name, Optional.of(scene));
        } catch (InvalidSettings e) {
            problems.addAll(e);
            return new World(name, Optional.empty());
        }
    }

    private Scene mapped(Maps.Found map) {
        return mapFacts.scene(map.grid(), map.warnings());
    }

    private static Optional<Touch> touch(Section world) {
        return world.has(Format.ON_COLLISION.name())
                ? world.value(Format.ON_COLLISION).flatMap(Touch::of)
                : Optional.empty();
    }

    private Scene scene(String path, Location at) {
        SceneFormat format = catalog.formatOf(path, files)
                .orElseThrow(() -> new InvalidSettings(
                        at,
                        "'%s' is not a kind of world that is known here.".formatted(path),
                        path.endsWith(".yaml")
                                ? "Maybe it is a map: write {map: %s}. A world's name ends with .world.yaml."
                                        .formatted(path)
                                : Suggestion.among(
                                        path.substring(Math.max(0, path.lastIndexOf('.'))),
                                        catalog.formats().keySet())));
        files.read(path, MAX_BYTES, at); // a file that is missing is told where it is named
        return format.read(path, files, seeds.of("world"));
    }

    /// Of the robots that a world brings along, those of one make together.
    ///
    /// @param world where it is named
    /// @param mrs of all of them
    List<Role> roles(Scene scene, Section world, Mrs mrs) {
        var byMake = new LinkedHashMap<String, List<RobotSpec>>();
        scene.robots()
                .forEach(spec -> byMake.computeIfAbsent(spec.role(), _ -> new ArrayList<>())
                        .add(spec));
        return byMake.entrySet().stream()
                .map(entry -> role(entry.getKey(), entry.getValue(), scene, world, mrs))
                .toList();
    }

    private Role role(String name, List<RobotSpec> specs, Scene scene, Section world, Mrs mrs) {
        var robots = new ArrayList<PlannedRobot>();
        for (RobotSpec spec : specs) {
            robots.add(outfitter.robot(spec, mrs, served(spec, scene)));
        }
        return Role.of(name, world, robots, inCommon(robots), true);
    }

    /// What a robot has to be given for what servers are asked to offer of it.
    private List<PlannedDevice> served(RobotSpec spec, Scene scene) {
        var devices = new ArrayList<PlannedDevice>();
        for (RobotService service : scene.services()) {
            if (service.robot().equals(Optional.of(spec.id()))) {
                service.software()
                        .forEach(wanted -> device(service, wanted, spec).ifPresent(devices::add));
            }
        }
        return devices;
    }

    private Optional<PlannedDevice> device(RobotService service, RobotService.Software wanted, RobotSpec spec) {
        Optional<DeviceDriver> driver =
                Catalog.find("device driver", catalog.drivers(), wanted.driver(), service.location(), problems);
        Optional<String> refusal = driver.flatMap(own -> own.refusal(spec.model()));
        refusal.ifPresent(why -> problems.add(
                service.location(), "'%s' can't work on robot '%s'.".formatted(service.driver(), spec.id()), why));
        var section = new Section(wanted.name(), wanted.settings(), problems);
        return driver.filter(_ -> refusal.isEmpty())
                .flatMap(own -> section.arguments(own.parameters())
                        .map(options -> new PlannedDevice(
                                wanted.name(),
                                own,
                                options,
                                seeds.of("device/" + spec.id() + "/" + wanted.name()),
                                wanted.mapFromStart())));
    }

    /// Types of the devices that all of them have or can be given.
    private static List<Class<? extends Device>> inCommon(List<PlannedRobot> robots) {
        var common = new ArrayList<Class<? extends Device>>();
        common.add(DriveBase.class);
        var models = new IdentityHashMap<RobotModel, Boolean>();
        robots.forEach(robot -> models.put(robot.spec().model(), true));
        robots.getFirst().spec().model().sensors().values().forEach(part -> {
            if (models.keySet().stream().allMatch(model -> DeviceSelector.has(model, part.makes()))) {
                common.add(part.makes());
            }
        });
        var given = new LinkedHashSet<>(DeviceSelector.gives(robots.getFirst()));
        robots.forEach(robot -> given.retainAll(DeviceSelector.gives(robot)));
        common.addAll(given);
        return common;
    }
}
