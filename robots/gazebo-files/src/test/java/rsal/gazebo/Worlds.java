package rsal.gazebo;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Shape;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// Worlds that stand in a test instead of on a disk.
final class Worlds {
    private final Map<String, byte[]> files = new HashMap<>();

    /// A world `worlds/test.sdf` with the given content.
    static Worlds of(String content) {
        return new Worlds().and("worlds/test.sdf", """
                <?xml version="1.0"?>
                <sdf version="1.9"><world name="yard">
                %s
                </world></sdf>
                """.formatted(content));
    }

    /// A model with one shape, and other elements.
    static String model(String name, String more, String geometry) {
        return """
                <model name="%s">%s<link name="link"><collision name="c"><geometry>%s</geometry></collision></link></model>
                """.formatted(name, more, geometry);
    }

    Worlds and(String path, String text) {
        return and(path, text.getBytes(StandardCharsets.UTF_8));
    }

    Worlds and(String path, byte[] bytes) {
        files.put(path, bytes);
        return this;
    }

    FileSource source() {
        return (path, most, askedAt) -> {
            byte[] bytes = files.get(normal(path));
            if (bytes == null || bytes.length > most) {
                throw new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), "");
            }
            return bytes;
        };
    }

    private static String normal(String path) {
        return java.nio.file.Path.of(path).normalize().toString();
    }

    Scene read() {
        return new SdfFormat(Map.of()).read("worlds/test.sdf", source(), 1);
    }

    Entity thing(String name) {
        return read().things().stream()
                .filter(thing -> thing.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    List<String> notes() {
        return read().warnings().stream().map(Problem::message).toList();
    }

    /// What is wrong with it.
    String error() {
        try {
            read();
            return "";
        } catch (InvalidSettings e) {
            return e.problems().getFirst().message();
        }
    }

    /// Whether something of a thing covers a point of the floor.
    static boolean covers(Entity thing, double x, double y) {
        Point2d inside = thing.mapFromEntity().inverse().transform(new Point2d(x, y));
        return thing.blocks().stream().anyMatch(block -> covers(block.prism().shape(), inside));
    }

    static boolean covers(Shape shape, Point2d point) {
        return switch (shape) {
            case Shape.Disc disc -> disc.center().distanceTo(point) <= disc.radius();
            case Shape.Polygon polygon -> {
                boolean odd = false;
                List<Point2d> corners = polygon.corners();
                for (int i = 0; i < corners.size(); i++) {
                    Point2d a = corners.get(i);
                    Point2d b = corners.get((i + 1) % corners.size());
                    if (a.y() > point.y() != b.y() > point.y()
                            && point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                        odd = !odd;
                    }
                }
                yield odd;
            }
        };
    }

    static Pose2d pose(double x, double y, double degrees) {
        return new Pose2d(x, y, Math.toRadians(degrees));
    }
}
