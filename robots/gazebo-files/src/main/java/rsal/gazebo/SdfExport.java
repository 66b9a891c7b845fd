package rsal.gazebo;

import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.gazebo.RectangleCover.Cells;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.world.SceneExport;

/// Writes worlds for Gazebo Sim in SDF 1.9, with a configuration for `ros_gz_bridge` beside it.
public final class SdfExport implements SceneExport {
    private static final String VERSION = "1.9";
    private static final int MOST_BOXES = 20_000; // of walls
    private static final int MANY_BOXES = 5_000;
    private static final int MOST_THINGS = 10_000;
    private static final double USUAL_HEIGHT = 2; // of walls for which heights don't matter [m]
    private static final double DENSITY = 200; // of things that can be moved [kg/m³]

    @Override
    public String suffix() {
        return ".sdf";
    }

    @Override
    public Exported write(Scene scene, String name, Location asked) {
        var writing = new Writing(scene, name, asked);
        writing.world();
        var files = new LinkedHashMap<String, byte[]>();
        files.put(name + ".sdf", writing.xml.toString().getBytes(StandardCharsets.UTF_8));
        if (!scene.robots().isEmpty()) {
            files.put(name + ".bridge.yaml", writing.bridge.toString().getBytes(StandardCharsets.UTF_8));
        }
        return new Exported(
                files,
                List.copyOf(writing.notes),
                "%s of walls, %s, %s"
                        .formatted(
                                counted(writing.boxes, "box", "boxes"),
                                counted(scene.things().size(), "thing", "things"),
                                counted(scene.robots().size(), "robot", "robots")));
    }

    private static String counted(int count, String one, String several) {
        return count + " " + (count == 1 ? one : several);
    }

    private static final class Writing {
        private final Scene scene;
        private final String name;
        private final Location asked;
        private final SdfXml xml = new SdfXml();
        private final ShapeWriter shapes = new ShapeWriter(xml);
        private final BridgeConfig bridge = new BridgeConfig();
        private final Set<String> notes = new LinkedHashSet<>();
        private final Set<String> names = new HashSet<>(Set.of("world", "ground_plane", "sun"));
        private int boxes;

        Writing(Scene scene, String name, Location asked) {
            this.scene = scene;
            this.name = name;
            this.asked = asked;
        }

        void world() {
            if (scene.things().size() > MOST_THINGS) {
                throw new InvalidSettings(
                        asked,
                        "This world has %d things; at most %d are written for Gazebo."
                                .formatted(scene.things().size(), MOST_THINGS),
                        "");
            }
            xml.comment("Written by RSAL. Lengths in m, angles in radians.");
            xml.open("sdf", "version", VERSION);
            xml.open("world", "name", scene.title().isBlank() ? name : plain(scene.title()));
            surroundings();
            floor();
            for (SolidRaster walls : scene.walls()) {
                walls(walls);
            }
            scene.things().forEach(this::thing);
            var robots = new RobotWriter(xml, shapes, bridge, notes);
            for (RobotSpec robot : scene.robots()) {
                robots.write(free(robot.id()), robot, body(robot));
            }
            xml.close("world").close("sdf");
        }

        private Entity body(RobotSpec robot) {
            Entity reported = scene.robotBodies().get(robot.id());
            if (reported != null) {
                return reported;
            }
            Rgb color = Rgb.parse(robot.color()).orElse(Surface.PLAIN.color());
            return new Entity(
                    robot.id(),
                    Entity.blocks(robot.model().body(), color),
                    robot.mapFromBase()
                            .orElseThrow(() -> new InvalidSettings(
                                    asked, "Robot '%s' has no place in this world.".formatted(robot.id()), "")),
                    0);
        }

        private void surroundings() {
            xml.open("physics", "name", "usual", "type", "ignored")
                    .numbers("max_step_size", 0.002)
                    .numbers("real_time_factor", 1)
                    .close("physics");
            system("physics", "Physics");
            system("user-commands", "UserCommands");
            system("scene-broadcaster", "SceneBroadcaster");
            xml.open("plugin", "filename", "gz-sim-sensors-system", "name", "gz::sim::systems::Sensors")
                    .leaf("render_engine", "ogre2")
                    .close("plugin");
            xml.open("light", "name", "sun", "type", "directional")
                    .numbers("pose", 0, 0, 10, 0, 0, 0)
                    .leaf("cast_shadows", "true")
                    .leaf("diffuse", "0.8 0.8 0.8 1")
                    .leaf("specular", "0.2 0.2 0.2 1")
                    .leaf("direction", "-0.5 0.1 -0.9")
                    .close("light");
        }

        private void system(String file, String system) {
            xml.open("plugin", "filename", "gz-sim-" + file + "-system", "name", "gz::sim::systems::" + system)
                    .close("plugin");
        }

        private void floor() {
            OccupancyGrid map = scene.map();
            double length = map.width() * map.resolution();
            double width = map.height() * map.resolution();
            xml.open("model", "name", "ground_plane").leaf("static", "true");
            xml.numbers("pose", map.originX() + length / 2, map.originY() + width / 2, 0, 0, 0, 0);
            xml.open("link", "name", "link");
            for (String kind : List.of("collision", "visual")) {
                xml.open(kind, "name", kind).open("geometry").open("plane").leaf("normal", "0 0 1");
                xml.numbers("size", length, width).close("plane").close("geometry");
                if (kind.equals("visual")) {
                    shapes.color(new Rgb(0xcc, 0xcc, 0xcc));
                }
                xml.close(kind);
            }
            xml.close("link").close("model");
        }

        private void walls(SolidRaster walls) {
            boolean finite = Double.isFinite(walls.highest() - walls.lowest());
            double bottom = finite ? walls.lowest() : 0;
            double top = finite ? walls.highest() : USUAL_HEIGHT;
            if (!finite) {
                notes.add("Walls of maps have no height; they are written %.0f m high.".formatted(USUAL_HEIGHT));
            }
            List<Cells> cover = RectangleCover.of(walls.width(), walls.height(), walls.solid(), MOST_BOXES - boxes);
            boxes += cover.size();
            if (boxes > MOST_BOXES) {
                throw new InvalidSettings(
                        asked,
                        "The walls of this world take more than %d boxes.".formatted(MOST_BOXES),
                        "Use a floor plan with larger pixels, or fewer slanted walls.");
            }
            if (boxes > MANY_BOXES) {
                notes.add("Walls take more than %d boxes: loading them may take a minute.".formatted(MANY_BOXES));
            }
            if (cover.isEmpty()) {
                return;
            }
            xml.open("model", "name", free("walls")).leaf("static", "true");
            xml.numbers("pose", walls.left(), walls.bottom(), 0, 0, 0, 0).open("link", "name", "link");
            for (int i = 0; i < cover.size(); i++) {
                Cells cells = cover.get(i);
                double left = cells.column() * walls.cellX();
                double low = cells.row() * walls.cellY();
                double right = left + cells.columns() * walls.cellX();
                double high = low + cells.rows() * walls.cellY();
                var outline = new Shape.Polygon(List.of(
                        new Point2d(left, low),
                        new Point2d(right, low),
                        new Point2d(right, high),
                        new Point2d(left, high)));
                piece(i, new Block(new Prism(outline, bottom, top, Optional.empty()), walls.surface()));
            }
            xml.close("link").close("model");
        }

        /// What is in the way as a collision shape, what sensors see as a visual.
        private void piece(int number, Block block) {
            Surface surface = block.surface();
            if (surface.obstacle()) {
                shapes.collision("c" + number, block.prism(), Optional.empty());
            }
            if (surface.seenByRangers()) {
                shapes.visual("v" + number, block.prism(), surface.color());
            } else {
                notes.add("What laser scanners look through is written without a visual shape: cameras don't see it.");
            }
            if (surface.fiducial() != 0) {
                notes.add("Markers are not written: Gazebo has none.");
            }
        }

        private void thing(Entity thing) {
            boolean moves =
                    thing.blocks().stream().anyMatch(block -> block.surface().grippable());
            xml.open("model", "name", free(thing.name())).leaf("static", moves ? "false" : "true");
            xml.numbers(
                    "pose",
                    thing.mapFromEntity().x(),
                    thing.mapFromEntity().y(),
                    thing.height(),
                    0,
                    0,
                    thing.mapFromEntity().theta());
            xml.open("link", "name", "link");
            if (moves) {
                var body = new Solid(thing.blocks().stream().map(Block::prism).toList());
                Footprint hull = body.hull();
                double floor =
                        body.pieces().stream().mapToDouble(Prism::bottom).min().orElseThrow();
                double area = Shape.Polygon.of(hull).area();
                double mass = Math.clamp(DENSITY * area * (body.top() - floor), 0.01, 100);
                shapes.inertia(hull, floor, body.top(), mass);
            }
            List<Block> blocks = thing.blocks();
            for (int i = 0; i < blocks.size(); i++) {
                piece(i, blocks.get(i));
            }
            xml.close("link").close("model");
        }

        /// A name that SDF can have and nothing else has.
        private String free(String wanted) {
            String plain = plain(wanted);
            String name = plain;
            for (int i = 2; !names.add(name); i++) {
                name = plain + "_" + i;
            }
            return name;
        }

        /// Colons set the names of links off from those of models, and names in underscores are Gazebo's own.
        private static String plain(String name) {
            String plain = name.replace("::", "_").replaceAll("^__|__$", "_").strip();
            return plain.isEmpty() ? "unnamed" : plain;
        }
    }
}
