package rsal.testkit.fake;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.SimulationControl.Thing;
import rsal.testkit.ObviousRays;

/// Walls, and things that are as large as the circle around their origin that holds them.
final class FakeWorld {
    private final ObviousRays rays;
    private final Map<String, Thing> things = new LinkedHashMap<>();

    FakeWorld(ObviousRays rays) {
        this.rays = rays;
    }

    ObviousRays rays() {
        return rays;
    }

    List<Thing> things() {
        return List.copyOf(things.values());
    }

    List<String> names() {
        return List.copyOf(things.keySet());
    }

    Optional<Thing> find(String name) {
        return Optional.ofNullable(things.get(name));
    }

    void add(Thing thing) {
        things.put(thing.name(), thing);
    }

    boolean remove(String name) {
        return things.remove(name) != null;
    }

    void move(String name, Pose2d mapFromThing) {
        things.computeIfPresent(
                name,
                (_, t) -> new Thing(
                        name,
                        mapFromThing,
                        t.body(),
                        t.color(),
                        t.obstacle(),
                        t.grippable(),
                        t.marker(),
                        t.givingPower()));
    }

    static double radius(Thing thing) {
        return thing.body().hull().circumscribedRadius();
    }

    /// Distance from a place to the nearest wall or obstacle [m].
    double clearance(double x, double y) {
        double nearest = rays.clearance(x, y);
        for (Thing thing : things.values()) {
            if (thing.obstacle()) {
                nearest = Math.min(nearest, distance(thing, x, y));
            }
        }
        return nearest;
    }

    /// Distance from a place to a thing [m]; negative inside of it.
    static double distance(Thing thing, double x, double y) {
        return Math.hypot(thing.mapFromThing().x() - x, thing.mapFromThing().y() - y) - radius(thing);
    }

    /// Distance along the x axis of a pose to a disc [m]; +∞ when it misses.
    static double range(Pose2d mapFromRay, Pose2d mapFromDisc, double radius) {
        Pose2d rayFromDisc = mapFromRay.inverse().compose(mapFromDisc);
        double half = Math.sqrt(radius * radius - rayFromDisc.y() * rayFromDisc.y()); // NaN: it misses
        double range = rayFromDisc.x() + half < 0 ? Double.NaN : Math.max(0, rayFromDisc.x() - half);
        return Double.isNaN(range) ? Double.POSITIVE_INFINITY : range;
    }

    /// Whether no wall is between a sensor and a place; things hide nothing.
    boolean sees(Pose2d mapFromSensor, Point2d place) {
        double bearing = mapFromSensor.bearingTo(place);
        return rays.range(mapFromSensor.compose(new Pose2d(0, 0, bearing)))
                > mapFromSensor.position().distanceTo(place);
    }
}
