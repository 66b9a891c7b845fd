package rsal.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
    private final BodyGrid now;
    private final BodyGrid seen; // where sensors see them
    private final BodyGrid.Found near = new BodyGrid.Found();
    private @Nullable Body obstacle; // null: a wall

    public World(Walls walls) {
        this.walls = walls;
        this.now = new BodyGrid(walls.left(), walls.bottom(), walls.sizeX(), walls.sizeY());
        this.seen = new BodyGrid(walls.left(), walls.bottom(), walls.sizeX(), walls.sizeY());
    }

    /// Adds a robot where it has room, as [#hasRoom] tells.
    public Body add(String name, Footprint footprint, Pose2d mapFromBase) {
        var body = new Body(bodies.size(), name, footprint, mapFromBase);
        bodies.add(body);
        arrive(body);
        see(body);
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
            body.outline.copy(body.trial);
            arrive(body);
        }
        return free;
    }

    /// Moves a robot until it would touch something, or to the arc's end.
    ///
    /// @param arc from where the robot is
    /// @return how much of the arc it made, 0–1; when less than 1, [#obstacle] says why
    public double advance(Body body, Arc arc) {
        double made = sweep(body, arc);
        if (made > 0) {
            arrive(body);
        }
        return made;
    }

    private double sweep(Body body, Arc arc) {
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
            body.outline.copy(body.trial);
        }
        return made;
    }

    /// Who was in the way last; empty when it was a wall.
    public Optional<Body> obstacle() {
        return Optional.ofNullable(obstacle);
    }

    /// Whether two robots are within 1 cm of each other.
    public boolean touching(Body one, Body other) {
        return one.outline.separation(other.outline, STILL_TOUCHING) < STILL_TOUCHING;
    }

    /// Whether a robot is within 1 cm of a wall.
    public boolean touchingWall(Body body) {
        return walls.separation(body.outline, STILL_TOUCHING) < STILL_TOUCHING;
    }

    /// From now on sensors see robots where they are now, whatever moves while they look.
    public void look() {
        for (int i = 0; i < bodies.size(); i++) {
            see(bodies.get(i));
        }
    }

    private void arrive(Body body) {
        now.put(body.index, body.outline.x(), body.outline.y(), body.outline.radius());
    }

    private void see(Body body) {
        body.seen.copy(body.outline);
        seen.put(body.index, body.seen.x(), body.seen.y(), body.seen.radius());
    }

    /// Finds the bodies that reach into a circle, where sensors see them.
    void seenNear(double x, double y, double radius, BodyGrid.Found found) {
        seen.near(x, y, radius, found);
    }

    Walls walls() {
        return walls;
    }

    Body body(int index) {
        return bodies.get(index);
    }

    /// @param itself who is not in its own way; null for one that is not there yet
    private double clearance(Outline outline, @Nullable Body itself, double reach) {
        double fromWalls = walls.separation(outline, reach);
        obstacle = null;
        return clearanceOfRobots(outline, itself, fromWalls);
    }

    private double clearanceOfRobots(Outline outline, @Nullable Body itself, double reach) {
        double least = reach;
        now.near(outline.x(), outline.y(), outline.radius() + reach, near);
        for (int i = 0; i < near.count; i++) {
            Body other = bodies.get(near.circles[i]);
            if (other != itself) {
                double gap = outline.separation(other.outline, least);
                if (gap < least) {
                    least = gap;
                    obstacle = other;
                }
            }
        }
        return least;
    }
}
