package rsal.sim;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.map.FreeSpace;
import rsal.robot.RobotSpec;
import rsal.robot.RobotSystemProvider.InvalidRobots.Problem;
import rsal.sim.world.Body;
import rsal.sim.world.Solid;
import rsal.sim.world.Walls;
import rsal.sim.world.World;

/// Puts robots on the map: first those that have a start pose, then the others at random free places, each drawing
/// from a stream of its own.
final class Lineup {
    private static final double CLEARANCE = 0.4; // of random places from walls and from other robots [m]
    private static final double MARGIN = 0.05; // of a robot that may turn in place, from walls [m]

    private final OccupancyGrid map;
    private final Walls walls;
    private final World world;
    private final Seeds seeds;
    private final Map<Double, FreeSpace> spaces = new HashMap<>(); // by clearance
    private final Map<String, Body> bodies = new LinkedHashMap<>(); // by robot
    private final List<Problem> problems = new ArrayList<>();

    Lineup(OccupancyGrid map, List<RobotSpec> robots, Seeds seeds) {
        this.map = map;
        this.walls = Walls.of(map);
        this.world = new World(walls);
        this.seeds = seeds;
        for (RobotSpec robot : robots) {
            robot.mapFromBase().ifPresent(pose -> addAt(robot, pose));
        }
        boolean room = true;
        for (RobotSpec robot : robots) {
            if (room && robot.mapFromBase().isEmpty()) {
                room = addSomewhere(robot); // where one finds no place, the next would not either
            }
        }
    }

    /// Which robots are not on the map, and why.
    List<Problem> problems() {
        return List.copyOf(problems);
    }

    World world() {
        return world;
    }

    /// @throws IllegalArgumentException when the robot is not on the map
    Body body(String robot) {
        Body body = bodies.get(robot);
        if (body == null) {
            throw new IllegalArgumentException("Robot (%s) is not on the map.".formatted(robot));
        }
        return body;
    }

    private void addAt(RobotSpec robot, Pose2d pose) {
        Footprint footprint = robot.model().footprint();
        if (!pose.isFinite()) {
            refuse(robot, "The start pose (%s) must be finite.".formatted(pose));
        } else if (!map.contains(map.column(pose.x()), map.row(pose.y()))) {
            double right = map.originX() + map.width() * map.resolution();
            double top = map.originY() + map.height() * map.resolution();
            refuse(
                    robot,
                    "The start pose %s is outside the map, which reaches from %s to %s."
                            .formatted(at(pose.x(), pose.y()), at(map.originX(), map.originY()), at(right, top)));
        } else if (!walls.isFree(pose.x(), pose.y())) {
            refuse(
                    robot,
                    "The start pose %s is inside a wall.%s"
                            .formatted(at(pose.x(), pose.y()), suggestion(footprint, pose)));
        } else if (!world.hasRoom(Solid.of(footprint), pose, 0)) {
            refuse(
                    robot,
                    "At its start pose %s the robot would touch %s.%s"
                            .formatted(at(pose.x(), pose.y()), obstacle(), suggestion(footprint, pose)));
        } else {
            bodies.put(robot.id(), world.add(robot.id(), Solid.of(footprint), pose, 0));
        }
    }

    private boolean addSomewhere(RobotSpec robot) {
        Footprint footprint = robot.model().footprint();
        Optional<Pose2d> pose = space(footprint)
                .choose(seeds.stream(robot.id() + "/start"), p -> world.hasRoom(Solid.of(footprint), p, CLEARANCE));
        pose.ifPresentOrElse(
                place -> bodies.put(robot.id(), world.add(robot.id(), Solid.of(footprint), place, 0)),
                () -> refuse(robot, """
                        There is no free place left for it that is %s m from walls and from all other robots. \
                        Maybe take fewer robots or a larger map, or name a start pose.""".formatted(CLEARANCE)));
        return pose.isPresent();
    }

    private void refuse(RobotSpec robot, String message) {
        problems.add(new Problem(robot.id(), "pose", message));
    }

    private FreeSpace space(Footprint footprint) {
        double clearance = Math.max(CLEARANCE, footprint.circumscribedRadius() + MARGIN);
        return spaces.computeIfAbsent(clearance, c -> new FreeSpace(map, c));
    }

    private String obstacle() {
        return world.obstacle()
                .map(robot -> "robot (%s)".formatted(robot.name()))
                .orElse("a wall");
    }

    private String suggestion(Footprint footprint, Pose2d pose) {
        return space(footprint)
                .nearest(pose, p -> world.hasRoom(Solid.of(footprint), p, CLEARANCE))
                .map(place -> " Maybe %s, the nearest place with room?".formatted(at(place.x(), place.y())))
                .orElse("");
    }

    static String at(double x, double y) {
        return String.format(Locale.ROOT, "(%.2f, %.2f)", x, y);
    }
}
