package rsal.gazebo;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.model.RobotColors;
import rsal.model.xml.Transform;
import rsal.model.xml.XmlElement;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.Touch;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.world.MapPainter;
import rsal.world.Overlaps;
import rsal.world.Overlaps.Overlap;

/// Reads a world of Gazebo: models that stay where they are become things that maps show, others things that may be
/// moved, those that drive robots.
final class SdfWorldReader {
    private static final double ON_FLOOR = 0.05; // a robot that starts no higher or lower stands on the floor [m]

    private final String path;
    private final SdfFiles files;
    private final SdfNotes notes = new SdfNotes();
    private final BodyMaker bodies;
    private final SdfRobotMaker makes;
    private final List<Entity> fixed = new ArrayList<>();
    private final List<Entity> moving = new ArrayList<>();
    private final List<Entity> things = new ArrayList<>();
    private final List<RobotSpec> robots = new ArrayList<>();
    private final List<Entity> robotEntities = new ArrayList<>();
    private final Map<String, Entity> robotBodies = new HashMap<>();
    private final Map<String, Integer> roles = new HashMap<>(); // numbers
    private final Map<String, Location> starts = new HashMap<>(); // where robots are written, by id

    SdfWorldReader(String path, SdfFiles files) {
        this.path = path;
        this.files = files;
        this.bodies = new BodyMaker(files, notes);
        this.makes = new SdfRobotMaker(bodies, notes);
    }

    /// @throws InvalidSettings with the first error
    Scene scene() {
        String title = read();
        warnOfOverlaps();
        return new Scene(
                title,
                map(),
                Optional.empty(),
                Optional.empty(),
                Touch.STALL,
                List.of(),
                things,
                robots,
                robotBodies,
                Map.of(),
                Map.of(),
                contents(),
                List.of(),
                notes.all(path));
    }

    /// Reads all that is in it, and returns its name.
    ///
    /// @throws InvalidSettings with the first error
    String read() {
        XmlElement root = files.world();
        if (!root.name().equals("sdf")) {
            throw new InvalidSettings(
                    root.location(),
                    "This is not a world of Gazebo: it begins with '%s', not 'sdf'."
                            .formatted(SdfText.shortened(root.name())),
                    "Its first element must be <sdf version=\"1.9\">.");
        }
        XmlElement world = root.first("world")
                .orElseThrow(() -> new InvalidSettings(
                        root.location(),
                        "There is no 'world' in this file.",
                        root.first("model").isPresent() ? "It holds a model: write a world that includes it." : ""));
        List<SdfModel> models = new ModelReader(files, notes).models(world);
        var frames = new SdfFrames(world, models);
        models.forEach(model -> add(model, frames.find(model.name(), Optional.of(model.location()))));
        noteOthers(world);
        return world.attribute("name");
    }

    private void add(SdfModel model, Transform worldFromModel) {
        String name = model.name().replace('/', '.'); // as a slash is what sets devices off from robots
        Optional<SdfRobotMaker.Made> robot = makes.robot(model);
        if (robot.isPresent()) {
            addRobot(name, model, robot.get(), worldFromModel);
            return;
        }
        var flat = new Pose2d(worldFromModel.x(), worldFromModel.y(), worldFromModel.heading());
        Transform worldFromBody =
                Transform.of(new double[] {flat.x(), flat.y(), worldFromModel.z()}, new double[] {0, 0, flat.theta()});
        List<Block> blocks = bodies.blocks(model, worldFromBody.inverse().compose(worldFromModel), worldFromModel.z());
        if (!blocks.isEmpty()) {
            var thing = new Entity(name, blocks, flat, worldFromModel.z());
            things.add(thing);
            (model.isStatic() ? fixed : moving).add(thing);
        }
    }

    private void addRobot(String id, SdfModel model, SdfRobotMaker.Made made, Transform worldFromModel) {
        Transform worldFromBase = worldFromModel.compose(made.modelFromBase());
        var pose = new Pose2d(worldFromBase.x(), worldFromBase.y(), worldFromBase.heading());
        double height = Math.abs(worldFromBase.z()) <= ON_FLOOR ? 0 : worldFromBase.z();
        String role = made.model().name();
        roles.putIfAbsent(role, roles.size());
        Rgb color = made.model().body().pieces().stream()
                .flatMap(piece -> piece.color().stream())
                .findFirst()
                .orElseGet(() ->
                        Rgb.parse(RobotColors.of(roles.getOrDefault(role, 0))).orElseThrow());
        robots.add(new RobotSpec(id, role, made.model(), Optional.of(pose), color.toString()));
        var body = new Entity(id, Entity.blocks(made.model().body(), color), pose, height);
        robotEntities.add(body);
        starts.put(id, model.location());
        if (height != 0) {
            robotBodies.put(id, body);
        }
    }

    private void noteOthers(XmlElement world) {
        for (XmlElement child : world.children()) {
            switch (child.name()) {
                case "actor" ->
                    notes.add("actor", child.location(), "An actor, which walks by itself, is left out.", "");
                case "road", "population" ->
                    notes.add(
                            child.name(), child.location(), "An element '%s' is left out.".formatted(child.name()), "");
                case "state" ->
                    notes.add(
                            "state",
                            child.location(),
                            "The saved state is left out: models are where they are told to be at first.",
                            "");
                default -> {} // nothing that is solid
            }
        }
    }

    private void warnOfOverlaps() {
        for (Overlap overlap : Overlaps.of(List.of(), things, robotEntities)) {
            String id = overlap.robot().name();
            notes.add("overlap " + id, starts.getOrDefault(id, Location.of(path)), overlap.message(), Overlap.REMEDY);
        }
    }

    private OccupancyGrid map() {
        try {
            return new MapPainter(List.of(), fixed, robotEntities)
                    .around(moving)
                    .map();
        } catch (MapPainter.TooLarge e) {
            throw new InvalidSettings(Location.of(path), String.valueOf(e.getMessage()), "Maybe a 'pose' is wrong.");
        }
    }

    private SortedMap<String, Integer> contents() {
        var contents = new TreeMap<String, Integer>();
        if (!things.isEmpty()) {
            contents.put("thing", things.size());
        }
        robots.forEach(robot -> contents.merge(robot.role(), 1, Integer::sum));
        return contents;
    }
}
