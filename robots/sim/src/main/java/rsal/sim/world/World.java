package rsal.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Footprint;
import rsal.data.Pose2d;

/// Walls and the robots between them, none of which ever overlap.
///
/// Robots keep a hair of 1 mm between themselves and anything solid. That makes a way certain to check in finitely
/// many poses: a robot that is free by d at one pose and by a hair at the next, with no point of it moving farther
/// than d plus a hair between them, is free all the way (conservative advancement: Mirtich, Impulse-based Dynamic
/// Simulation of Rigid Body Systems, 1996).
public final class World {
    /// What obstacles are called that are no robots.
    public static final String WALL = "wall";

    private static final double HAIR = 0.001; // [m]
    private static final double LOOK_AHEAD = 0.3; // [m]; farther away nothing needs to be measured
    private static final double STILL_TOUCHING = 0.01; // [m]

    private final Walls walls;
    private final List<Body> bodies = new ArrayList<>();
    private String obstacle = WALL;

    public World(Walls walls) {
        this.walls = walls;
    }

    /// Adds a robot where it has room, as [#hasRoom] tells.
    public Body add(String name, Footprint footprint, Pose2d mapFromBase) {
        var body = new Body(name, footprint, mapFromBase);
        bodies.add(body);
        return body;
    }

    /// Whether a robot that is not there yet could stand somewhere. When not, [#obstacle] says why.
    ///
    /// @param apart how far from all other robots [m]
    public boolean hasRoom(Footprint footprint, Pose2d mapFromBase, double apart) {
        var outline = new Outline(footprint);
        outline.placeAt(mapFromBase);
        double fromRobots = Math.max(apart, HAIR);
        return clearance(outline, null, HAIR) >= HAIR && clearanceOfRobots(outline, null, fromRobots) >= fromRobots;
    }

    /// Puts a robot somewhere.
    ///
    /// @return false when it stays where it was, as something is in the way: [#obstacle]
    public boolean place(Body body, Pose2d mapFromBase) {
        body.trial.placeAt(mapFromBase);
        boolean free = clearance(body.trial, body, HAIR) >= HAIR;
        if (free) {
            body.outline.placeAt(mapFromBase);
        }
        return free;
    }

    /// Moves a robot until it would touch something, or to the arc's end.
    ///
    /// @param arc from where the robot is
    /// @return how much of the arc it made, 0–1; when less than 1, [#obstacle] says why
    public double advance(Body body, Arc arc) {
        double way = arc.longestWay(body.outline.radius());
        double reach = Math.clamp(way, HAIR, LOOK_AHEAD);
        double made = way > 0 ? 0 : 1;
        double free = clearance(body.outline, body, reach);
        while (made < 1) {
            double step = Math.min(1 - made, (free + HAIR) / way);
            body.trial.placeAt(arc.at(made + step));
            free = clearance(body.trial, body, reach);
            while (free < HAIR && step * way > HAIR / 4) {
                step /= 2;
                body.trial.placeAt(arc.at(made + step));
                free = clearance(body.trial, body, reach);
            }
            if (free < HAIR) {
                return made;
            }
            made += step;
            body.outline.placeAt(body.trial.pose());
        }
        return made;
    }

    /// What was in the way last: a robot's name or [#WALL].
    public String obstacle() {
        return obstacle;
    }

    /// Whether a robot is within 1 cm of another, or of a wall.
    public boolean touching(Body body, String other) {
        double gap = STILL_TOUCHING;
        for (Body candidate : bodies) {
            if (candidate.name().equals(other)) {
                gap = body.outline.separation(candidate.outline, STILL_TOUCHING);
            }
        }
        if (other.equals(WALL)) {
            gap = walls.separation(body.outline, STILL_TOUCHING);
        }
        return gap < STILL_TOUCHING;
    }

    /// From now on sensors see robots where they are now, whatever moves while they look.
    public void look() {
        for (Body body : bodies) {
            body.seen.placeAt(body.pose());
        }
    }

    Walls walls() {
        return walls;
    }

    List<Body> bodies() {
        return bodies;
    }

    /// @param itself who is not in its own way; null for one that is not there yet
    private double clearance(Outline outline, @Nullable Body itself, double reach) {
        double fromWalls = walls.separation(outline, reach);
        obstacle = WALL;
        return clearanceOfRobots(outline, itself, fromWalls);
    }

    private double clearanceOfRobots(Outline outline, @Nullable Body itself, double reach) {
        double least = reach;
        for (int i = 0; i < bodies.size(); i++) {
            Body other = bodies.get(i);
            if (other != itself) {
                double gap = outline.separation(other.outline, least);
                if (gap < least) {
                    least = gap;
                    obstacle = other.name();
                }
            }
        }
        return least;
    }
}
