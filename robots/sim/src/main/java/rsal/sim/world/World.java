package rsal.sim.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.DoubleConsumer;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.robot.Shift;

/// Walls and the bodies between them. No body that moves by itself gets into what is in its way, and one into which
/// something was [#put] gets no deeper into it.
///
/// Bodies keep a hair of 1 mm between themselves and anything solid. That makes a way certain to check in
/// finitely many poses: a body that is free by d at one pose and by a hair at the next, with no point of it
/// moving farther than d plus a hair between them, is free all the way (conservative advancement: Mirtich,
/// Impulse-based Dynamic Simulation of Rigid Body Systems, 1996).
public final class World {
    /// What obstacles are called that are no bodies.
    public static final String WALL = "wall";

    static final double HAIR = 0.001; // [m]
    private static final double FARTHEST = 1e6; // [m]; as poses in files
    private static final double LOOK_AHEAD = 0.3; // [m]; farther away nothing needs to be measured
    private static final double TOUCH = 0.01; // [m]; bodies that are so near touch, as far as others can tell

    private final List<RasterWalls> walls;
    private final Extent extent;
    private final Set<Body> bodies = new LinkedHashSet<>();
    private final List<@Nullable Body> owners = new ArrayList<>(); // by slot
    private final List<@Nullable PlacedShape> now = new ArrayList<>(); // by slot
    private final Deque<Integer> freeSlots = new ArrayDeque<>();
    private final PieceGrid nowGrid;
    private final SensorView sensorView;
    private final PieceGrid.Found near = new PieceGrid.Found();
    private @Nullable Body obstacle; // null: a wall

    /// @param extent where most bodies are; elsewhere they may be, too, but are found more slowly
    public World(List<RasterWalls> walls, Extent extent) {
        this.walls = List.copyOf(walls);
        this.extent = extent;
        this.nowGrid = new PieceGrid(extent);
        this.sensorView = new SensorView(extent, freeSlots::add);
    }

    /// The world of a map.
    public World(RasterWalls walls) {
        this(List.of(walls), walls.extent());
    }

    /// Where something may stand: in the extent where walls fence it, else as far as anybody can want.
    public Extent bounds() {
        return walls.stream().anyMatch(RasterWalls::isFenced)
                ? extent
                : new Extent(-FARTHEST, -FARTHEST, FARTHEST, FARTHEST);
    }

    /// Adds a body, whether it has room ([#hasRoom]) or not.
    ///
    /// @param height of its base above ground [m]
    public Body add(String name, List<CollisionShape> chunks, Pose2d mapFromBase, double height) {
        int[] slots = new int[chunks.size()];
        for (int i = 0; i < slots.length; i++) {
            slots[i] = freeSlot();
        }
        var body = new Body(name, chunks, slots);
        body.figure.placeAt(mapFromBase, height);
        for (int i = 0; i < slots.length; i++) {
            owners.set(slots[i], body);
            now.set(slots[i], body.figure.pieces[i]);
        }
        bodies.add(body);
        sensorView.changed(body);
        arrive(body);
        sensorView.showUnlessWatched();
        return body;
    }

    private int freeSlot() {
        Integer free = freeSlots.poll();
        if (free != null) {
            return free;
        }
        owners.add(null);
        now.add(null);
        return owners.size() - 1;
    }

    /// Takes a body out of the world.
    public void remove(Body body) {
        if (bodies.remove(body)) {
            leave(body);
            for (int slot : body.slots) {
                owners.set(slot, null);
                now.set(slot, null);
            }
            sensorView.gone(body);
        }
    }

    /// Lets a body vanish for a while. It must not be moved meanwhile.
    public void hide(Body body) {
        body.hidden = true;
        leave(body);
        sensorView.hidden(body);
    }

    /// Lets a body that was hidden appear where it was.
    ///
    /// @return false when it stays hidden, as something is in the way: [#obstacle]
    public boolean reveal(Body body) {
        boolean free = clearance(body.figure, body, HAIR) >= HAIR;
        if (free) {
            body.hidden = false;
            sensorView.changed(body);
            arrive(body);
            sensorView.showUnlessWatched();
        }
        return free;
    }

    /// Whether sensors look, maybe on other threads. What they see stays as it is meanwhile.
    public void watched(boolean now) {
        sensorView.watched(now);
    }

    /// A body takes another along: it is in nobody's way any more, and who carries it looks through it.
    public void pickUp(Body thing, Body carrier) {
        thing.carrier = carrier;
        leave(thing);
        sensorView.changed(thing);
    }

    /// Moves what was picked up, through whatever is there.
    public void carry(Body thing, Pose2d mapFromThing, double height) {
        thing.figure.placeAt(mapFromThing, height);
        sensorView.moved(thing);
    }

    /// Puts down what was picked up.
    ///
    /// @param height of its base above ground [m]
    /// @return false when it stays where it was, as something is in the way: [#obstacle]
    public boolean putDown(Body thing, Pose2d mapFromThing, double height) {
        thing.trial.placeAt(mapFromThing, height);
        boolean free = clearance(thing.trial, thing, HAIR) >= HAIR;
        if (free) {
            thing.figure.placeAt(thing.trial);
            thing.carrier = null;
            sensorView.changed(thing);
            arrive(thing);
        }
        return free;
    }

    /// Puts down what was picked up where it is, whether it has room or not.
    ///
    /// @param height of its base above ground [m]
    public void drop(Body thing, double height) {
        thing.figure.placeAt(thing.pose(), height);
        thing.carrier = null;
        sensorView.changed(thing);
        arrive(thing);
    }

    /// Whether a body that is not there yet could stand somewhere on the ground. When not, [#obstacle] says why.
    ///
    /// @param apart how far from all other bodies [m]
    public boolean hasRoom(List<CollisionShape> chunks, Pose2d mapFromBase, double apart) {
        return hasRoom(chunks, mapFromBase, 0, apart);
    }

    /// As above, at a height.
    ///
    /// @param height of its base above ground [m]
    public boolean hasRoom(List<CollisionShape> chunks, Pose2d mapFromBase, double height, double apart) {
        var figure = new Figure(chunks);
        figure.placeAt(mapFromBase, height);
        double fromBodies = Math.max(apart, HAIR);
        return clearance(figure, null, HAIR) >= HAIR
                && clearanceOfBodies(figure, null, fromBodies, false) >= fromBodies;
    }

    /// Puts a body somewhere.
    ///
    /// @return false when it stays where it was, as something is in the way: [#obstacle]
    public boolean place(Body body, Pose2d mapFromBase) {
        body.trial.placeAt(mapFromBase, body.height());
        boolean free = clearance(body.trial, body, HAIR) >= HAIR;
        if (free) {
            body.figure.placeAt(body.trial);
            arrive(body);
        }
        return free;
    }

    /// Puts a body somewhere, whether it has room or not.
    public void put(Body body, Pose2d mapFromBase) {
        put(body, mapFromBase, body.height());
    }

    /// As above, at a height.
    ///
    /// @param height of its base above ground [m]
    public void put(Body body, Pose2d mapFromBase, double height) {
        body.figure.placeAt(mapFromBase, height);
        arrive(body);
    }

    /// Moves a body until it would touch something, or to the arc's end.
    ///
    /// @param arc from where the body is
    /// @return how much of the arc it made, 0–1; when less than 1, [#obstacle] says why
    public double advance(Body body, Arc arc) {
        double made = sweep(body, arc);
        if (made > 0) {
            arrive(body);
        }
        return made;
    }

    /// As [#advance], of which others do not know yet.
    double sweep(Body body, Arc arc) {
        double distance = arc.longestDistance(body.figure.radius());
        if (distance == 0) {
            return 1;
        }
        if (body.jam.holds(arc)) {
            obstacle = body.jam.obstacle();
            return 0;
        }
        double reach = Math.min(distance + HAIR, LOOK_AHEAD);
        double free = clearance(body.figure, body, reach);
        if (free >= distance + HAIR) { // as most are
            body.figure.placeAt(arc.at(1), body.height());
            return 1;
        }
        double made = free < 0
                ? new Withdrawal(this, body).goOn(arc, distance)
                : approach(
                        body,
                        distance,
                        free,
                        figure -> clearance(figure, body, reach),
                        part -> body.trial.placeAt(arc.at(part), body.height()));
        if (made == 0 && free >= 0) { // out of others it goes by strides, and farther once it is out
            body.jam.begin(arc, obstacle);
        }
        return made;
    }

    /// Lets actuators carry pieces of a body until one would touch something, or all the way.
    ///
    /// @param distance that any point of it makes, at most [m]
    /// @param shifts of each of its [Body#carriers], by part of the way
    /// @return how much of the way it made, 0–1; when less than 1, [#obstacle] says why
    public double bend(Body body, double distance, DoubleFunction<List<Shift>> shifts) {
        body.trial.placeAt(body.figure);
        double reach = Math.min(distance + HAIR, LOOK_AHEAD);
        boolean rises = !rises(shifts.apply(0)).equals(rises(shifts.apply(1)));
        ToDoubleFunction<Figure> room = figure -> clearance(figure, body, reach, rises);
        double free = room.applyAsDouble(body.figure);
        double made = approach(body, distance, free, room, part -> body.trial.bend(shifts.apply(part)));
        body.trial.placeAt(body.figure);
        if (made > 0) {
            arrive(body);
        }
        return made;
    }

    private static List<Double> rises(List<Shift> shifts) {
        return shifts.stream().map(Shift::rise).toList();
    }

    /// Advances conservatively.
    ///
    /// @param distance longest of any point [m]
    /// @param free room that it has at first [m]
    /// @param roomOf how much room a figure has, as far as that is of interest [m]
    /// @param tryPart places the body's trial where it is after a part of the way
    private double approach(
            Body body, double distance, double free, ToDoubleFunction<Figure> roomOf, DoubleConsumer tryPart) {
        double made = 0;
        double room = free;
        while (made < 1) {
            double step = Math.min(
                    1 - made, (Math.max(0, room) + HAIR) / distance); // less than 0 if it was put into something
            tryPart.accept(made + step);
            room = roomOf.applyAsDouble(body.trial);
            while (room < HAIR && step * distance > HAIR / 4) {
                step /= 2;
                tryPart.accept(made + step);
                room = roomOf.applyAsDouble(body.trial);
            }
            if (room < HAIR) {
                return made;
            }
            made += step;
            body.figure.placeAt(body.trial);
        }
        return made;
    }

    /// Lets a body that touched something on its way go on along that, as [Sliding] says.
    ///
    /// @param arc on which it was stopped; [#obstacle] stays what it was then
    /// @param made part of the arc that it made
    /// @return whether it moved
    public boolean slide(Body body, Arc arc, double made) {
        Body touched = obstacle;
        boolean moved = new Sliding(this, body).goOn(arc, made);
        if (moved) {
            arrive(body);
        }
        obstacle = touched;
        return moved;
    }

    /// Notes who is in the way; null for a wall.
    void obstacle(@Nullable Body other) {
        obstacle = other;
    }

    /// Who was in the way last; empty when it was a wall.
    public Optional<Body> obstacle() {
        return Optional.ofNullable(obstacle);
    }

    /// Whether two bodies are within 1 cm of each other.
    public boolean touching(Body one, Body other) {
        return touch(
                one,
                other,
                (piece, second) ->
                        piece.surface.obstacle() && second.surface.obstacle() && piece.gapAbove(second) < TOUCH);
    }

    /// Whether a body is within 1 cm of a wall.
    public boolean touchingWall(Body body) {
        return clearanceOfWalls(body.figure, TOUCH) < TOUCH;
    }

    /// Whether a body is within 1 cm of another, seen from above: beside it, on it, under it.
    public boolean meets(Body one, Body other) {
        return touch(one, other, (_, _) -> true);
    }

    private static boolean touch(Body one, Body other, BiPredicate<PlacedShape, PlacedShape> counts) {
        for (PlacedShape piece : one.figure.pieces) {
            for (PlacedShape second : other.figure.pieces) {
                if (counts.test(piece, second) && piece.separation(second) < TOUCH) {
                    return true;
                }
            }
        }
        return false;
    }

    /// From now on sensors see bodies where they are now, whatever moves while they look. Not while they are
    /// [#watched].
    public void look() {
        sensorView.look();
    }

    /// Whether a figure that is no body overlaps what is in a body's way.
    boolean isBlocked(Figure figure, Body itself) {
        return clearance(figure, itself, HAIR) <= 0;
    }

    private void arrive(Body body) {
        enter(nowGrid, body.slots, body.figure);
        sensorView.moved(body);
    }

    /// It is in nobody's way any more.
    private void leave(Body body) {
        body.figure.takeAway();
        for (int slot : body.slots) {
            nowGrid.remove(slot);
        }
    }

    static void enter(PieceGrid grid, int[] slots, Figure figure) {
        for (int i = 0; i < slots.length; i++) {
            PlacedShape piece = figure.pieces[i];
            grid.put(slots[i], piece.x(), piece.y(), piece.radius());
        }
    }

    List<RasterWalls> walls() {
        return walls;
    }

    /// Finds the pieces that reach into a circle, where they are now. Overwritten by whatever moves or asks next.
    PieceGrid.Found nowNear(double x, double y, double radius) {
        nowGrid.near(x, y, radius, near);
        return near;
    }

    PlacedShape now(int slot) {
        return Objects.requireNonNull(now.get(slot));
    }

    /// Whose piece is there now.
    Body owner(int slot) {
        return Objects.requireNonNull(owners.get(slot));
    }

    /// What sensors see of bodies.
    SensorView sensorView() {
        return sensorView;
    }

    /// How much room a figure has [m], no more than `reach`.
    ///
    /// @param itself who is not in its own way; null for one that is not there yet
    double clearance(Figure figure, @Nullable Body itself, double reach) {
        return clearance(figure, itself, reach, false);
    }

    /// @param rises whether what is above or under it may get into its way, too: it counts as a hair farther away than
    /// it is, as it may be touched
    private double clearance(Figure figure, @Nullable Body itself, double reach, boolean rises) {
        double fromWalls = clearanceOfWalls(figure, reach);
        obstacle = null;
        return clearanceOfBodies(figure, itself, fromWalls, rises);
    }

    double clearanceOfWalls(Figure figure, double reach) {
        double least = reach;
        for (int i = 0; i < walls.size(); i++) {
            for (PlacedShape piece : figure.pieces) {
                if (piece.surface.obstacle()) {
                    least = Math.min(least, walls.get(i).separation(piece, least));
                }
            }
        }
        return least;
    }

    private double clearanceOfBodies(Figure figure, @Nullable Body itself, double reach, boolean rises) {
        double least = reach;
        for (PlacedShape piece : figure.pieces) {
            if (!piece.surface.obstacle()) {
                continue;
            }
            nowGrid.near(piece.x(), piece.y(), piece.radius() + least, near);
            for (int i = 0; i < near.count; i++) {
                Body owner = owner(near.slots[i]);
                PlacedShape other = Objects.requireNonNull(now.get(near.slots[i]));
                if (owner != itself && (obstructing(piece, other) || (rises && other.surface.obstacle()))) {
                    double gap = piece.separation(other);
                    if (gap < least && !piece.isLevelWith(other)) {
                        gap = Math.max(gap, piece.gapAbove(other) + HAIR);
                    }
                    if (gap < least) {
                        least = gap;
                        obstacle = owner;
                    }
                }
            }
        }
        return least;
    }

    static boolean obstructing(PlacedShape one, PlacedShape other) {
        return one.surface.obstacle() && other.surface.obstacle() && one.isLevelWith(other);
    }
}
