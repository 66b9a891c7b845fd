package rsal.sim;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.Surface;
import rsal.sim.world.Body;
import rsal.sim.world.CollisionShape;
import rsal.sim.world.Extent;
import rsal.sim.world.RasterWalls;
import rsal.sim.world.World;
import rsal.system.RobotSystemProvider.InvalidRobots.Problem;

/// Puts things and robots into the world: first those that have a place, then the others at random free places,
/// each drawing from a stream of its own.
final class SpawnPlacement {
    private static final double CLEARANCE = FreeSpace.START_CLEARANCE; // from walls and from other robots [m]
    private static final double MARGIN = 0.05; // of a robot that may turn in place, from all else [m]

    private final OccupancyGrid map;
    private final World world;
    private final Things things = new Things();
    private final RandomStreams seeds;
    private final Map<Double, FreeSpace> spaces = new HashMap<>(); // by clearance
    private final Map<List<Block>, List<CollisionShape>> chunks = new HashMap<>();
    private final Map<String, Body> bodies = new LinkedHashMap<>(); // by robot
    private final List<Problem> problems = new ArrayList<>();

    /// @param walls of the scene
    SpawnPlacement(Scene scene, List<RasterWalls> walls, List<RobotSpec> robots, RandomStreams seeds) {
        this.map = scene.map();
        this.world = new World(walls, extent(map));
        this.seeds = seeds;
        for (Entity thing : scene.things()) {
            things.add(
                    world.add(thing.name(), chunks(thing.blocks()), thing.mapFromEntity(), thing.height()),
                    thing.blocks(),
                    thing.givingPower());
        }
        for (RobotSpec robot : robots) {
            Entity known = scene.robotBodies().get(robot.id());
            if (known != null) {
                Body body = world.add(
                        robot.id(),
                        chunks(known.blocks()),
                        robot.mapFromBase().orElse(known.mapFromEntity()),
                        known.height());
                bodies.put(robot.id(), body);
            } else {
                robot.mapFromBase().ifPresent(pose -> addAt(robot, pose));
            }
        }
        boolean room = true;
        for (RobotSpec robot : robots) {
            if (room && robot.mapFromBase().isEmpty() && !bodies.containsKey(robot.id())) {
                room = addSomewhere(robot); // where one finds no place, the next would not either
            }
        }
    }

    private static Extent extent(OccupancyGrid map) {
        return new Extent(
                map.originX(),
                map.originY(),
                map.originX() + map.width() * map.resolution(),
                map.originY() + map.height() * map.resolution());
    }

    private List<CollisionShape> chunks(RobotSpec robot) {
        return chunks(blocks(robot));
    }

    /// Those of bodies that are alike are the same.
    private List<CollisionShape> chunks(List<Block> blocks) {
        return chunks.computeIfAbsent(blocks, CollisionShape::of);
    }

    /// What the body of a robot is made of that looks as its model says.
    static List<Block> blocks(RobotSpec robot) {
        Rgb color = Rgb.parse(robot.color()).orElse(Surface.PLAIN.color());
        List<Block> plain = Entity.blocks(robot.model().body(), color);
        return robot.marker().isEmpty() ? plain : marked(plain, robot.marker().getAsInt());
    }

    /// The same blocks with another marker.
    ///
    /// @param marker 0: none
    static List<Block> marked(List<Block> blocks, int marker) {
        return blocks.stream()
                .map(block -> new Block(block.prism(), block.surface().withMarker(marker)))
                .toList();
    }

    /// Which robots are not on the map, and why.
    List<Problem> problems() {
        return List.copyOf(problems);
    }

    Things things() {
        return things;
    }

    World world() {
        return world;
    }

    /// What a robot's body is made of.
    static List<Block> blocks(Scene scene, RobotSpec robot) {
        Entity known = scene.robotBodies().get(robot.id());
        return known == null ? blocks(robot) : known.blocks();
    }

    /// @throws IllegalArgumentException when the robot is not on the map
    Body body(String robot) {
        Body body = bodies.get(robot);
        if (body == null) {
            throw new IllegalArgumentException("Robot '%s' is not on the map.".formatted(robot));
        }
        return body;
    }

    private void addAt(RobotSpec robot, Pose2d pose) {
        Extent bounds = world.bounds();
        if (!pose.isFinite()) {
            refuse(robot, "The start pose '%s' must be finite.".formatted(pose));
        } else if (!bounds.contains(pose.x(), pose.y())) {
            refuse(
                    robot,
                    "The start pose %s is outside the map, which reaches from %s to %s."
                            .formatted(
                                    at(pose.x(), pose.y()),
                                    at(bounds.left(), bounds.bottom()),
                                    at(bounds.right(), bounds.top())));
        } else if (isOccupied(pose)) {
            refuse(
                    robot,
                    "The start pose %s is inside a wall.%s".formatted(at(pose.x(), pose.y()), suggestion(robot, pose)));
        } else if (!world.hasRoom(chunks(robot), pose, 0)) {
            refuse(
                    robot,
                    "At its start pose %s the robot would touch %s.%s"
                            .formatted(at(pose.x(), pose.y()), obstacle(), suggestion(robot, pose)));
        } else {
            bodies.put(robot.id(), world.add(robot.id(), chunks(robot), pose, 0));
        }
    }

    private boolean isOccupied(Pose2d pose) {
        int column = map.column(pose.x());
        int row = map.row(pose.y());
        return map.contains(column, row) && map.at(column, row) == OccupancyGrid.OCCUPIED;
    }

    private boolean addSomewhere(RobotSpec robot) {
        List<CollisionShape> chunks = chunks(robot);
        Optional<Pose2d> pose = space(robot, CLEARANCE)
                .choose(seeds.stream(robot.id() + "/start"), p -> world.hasRoom(chunks, p, CLEARANCE));
        pose.ifPresentOrElse(
                place -> bodies.put(robot.id(), world.add(robot.id(), chunks(robot), place, 0)),
                () -> refuse(robot, """
                        There is no free place left for it that is %s m from walls and from all other robots. \
                        Maybe take fewer robots or a larger map, or name a start pose.""".formatted(CLEARANCE)));
        return pose.isPresent();
    }

    private void refuse(RobotSpec robot, String message) {
        problems.add(new Problem(robot.id(), "pose", message));
    }

    /// Where its middle can be that far from walls, or so far that it can turn in place, if that is more.
    private FreeSpace space(RobotSpec robot, double fromWalls) {
        double radius = robot.model().footprint().circumscribedRadius();
        double clearance = Math.max(fromWalls, radius + MARGIN);
        return spaces.computeIfAbsent(clearance, c -> new FreeSpace(map, c));
    }

    private String obstacle() {
        return world.obstacle()
                .map(robot -> "robot '%s'".formatted(robot.name()))
                .orElse("a wall");
    }

    private String suggestion(RobotSpec robot, Pose2d pose) {
        List<CollisionShape> chunks = chunks(robot);
        return space(robot, 0)
                .nearest(pose, p -> world.hasRoom(chunks, p, MARGIN))
                .map(place -> " Maybe %s, the nearest place with room?".formatted(at(place.x(), place.y())))
                .orElse("");
    }

    static String at(double x, double y) {
        return String.format(Locale.ROOT, "(%.2f, %.2f)", x, y);
    }
}
