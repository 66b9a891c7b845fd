package rsal.bench.navigation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Value;
import rsal.yaml.Yaml;

/// A world of the BARN Challenge (D. Perille, A. Truong, X. Xiao, P. Stone, Benchmarking Metric Ground Navigation,
/// 2020): a field of upright cylinders that one must get through.
///
/// @param cylinders where they stand, and how thick they are [m]
/// @param path a short way through [m]; without start and goal
record BarnWorld(int number, List<Cylinder> cylinders, List<Point2d> path) {
    /// Where the robot stands at first, looking along y.
    static final Pose2d START = new Pose2d(-2.25, 3, Math.PI / 2);

    static final Point2d GOAL = new Point2d(-2.25, 13);
    private static final double FULL_SPEED = 2; // m/s

    BarnWorld {
        cylinders = List.copyOf(cylinders);
        path = List.copyOf(path);
    }

    /// @param radius [m]
    record Cylinder(Point2d middle, double radius) {}

    /// Length of the way over the path from start to goal [m].
    double length() {
        double length = 0;
        Point2d at = START.position();
        for (Point2d next : path) {
            length += at.distanceTo(next);
            at = next;
        }
        return length + at.distanceTo(GOAL);
    }

    /// What a run that succeeds is worth, as the challenge counts: the time that the path takes at full speed, by
    /// the time it took, of which no less than double and no more than eightfold counts. At most 0.5.
    double score(double seconds) {
        double optimal = length() / FULL_SPEED;
        return optimal / Math.clamp(seconds, 2 * optimal, 8 * optimal);
    }

    /// Reads a list of worlds, each with `world`, `cylinders` ([x, y, radius]) and `path` ([x, y]).
    static List<BarnWorld> read(Path file) throws IOException {
        var text = "worlds: " + Files.readString(file);
        var limits = new Yaml.Limits(1 << 26, 1 << 24);
        var worlds = new ArrayList<BarnWorld>();
        for (Value value :
                list(Yaml.read(file.toString(), text, limits).find("worlds").orElseThrow())) {
            var world = (Value.Mapping) value;
            var cylinders = list(world.find("cylinders").orElseThrow()).stream()
                    .map(BarnWorld::numbers)
                    .map(c -> new Cylinder(new Point2d(c.get(0), c.get(1)), c.get(2)))
                    .toList();
            var path = list(world.find("path").orElseThrow()).stream()
                    .map(BarnWorld::numbers)
                    .map(p -> new Point2d(p.get(0), p.get(1)))
                    .toList();
            int number = (int) number(world.find("world").orElseThrow());
            worlds.add(new BarnWorld(number, cylinders, path));
        }
        return List.copyOf(worlds);
    }

    private static List<Value> list(Value value) {
        return ((Value.Sequence) value).items();
    }

    private static List<Double> numbers(Value value) {
        return list(value).stream().map(BarnWorld::number).toList();
    }

    private static double number(Value value) {
        return ((Number) ((Value.Scalar) value).value()).doubleValue();
    }
}
