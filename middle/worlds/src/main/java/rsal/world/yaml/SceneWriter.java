package rsal.world.yaml;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Shape;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.scene.Touch;

/// Writes a scene as a world of our own that says the same: walls in cells become images beside it. What the scene
/// came from, and its warnings, are not written.
public final class SceneWriter {
    private final Scene scene;
    private final String base;
    private final YamlText text = new YamlText();
    private final Map<String, byte[]> images = new LinkedHashMap<>();

    private SceneWriter(Scene scene, String base) {
        this.scene = scene;
        this.base = base;
    }

    /// What was written.
    ///
    /// @param images by the name of their file, beside that of the world
    public record Written(String yaml, Map<String, byte[]> images) {}

    /// @param base how the names of images begin
    public static Written write(Scene scene, String base) {
        var writer = new SceneWriter(scene, base);
        writer.write();
        return new Written(writer.text.toString(), writer.images);
    }

    private void write() {
        text.add("rsal", (long) Keys.VERSION);
        if (!scene.title().isEmpty()) {
            text.add("title", scene.title());
        }
        scene.step().ifPresent(step -> text.add("step", step.toNanos() / 1e9));
        scene.end().ifPresent(end -> text.add("end", end.toNanos() / 1e9));
        if (scene.touch() != Touch.STALL) {
            text.add(Keys.ON_COLLISION.name(), scene.touch().word());
        }
        addIfAny("walls", scene.walls().stream().map(this::wall).toList());
        var things = new LinkedHashMap<String, Object>();
        scene.things().forEach(thing -> things.put(thing.name(), thing(thing)));
        addIfAny("things", things);
        var models = new ModelWriter(scene);
        var robots = new LinkedHashMap<String, Object>();
        scene.robots().forEach(robot -> robots.put(robot.id(), robot(robot, models.nameOf(robot))));
        addIfAny("parts", models.parts());
        addIfAny("models", models.models());
        addIfAny("robots", robots);
    }

    private void addIfAny(String key, Map<String, Object> group) {
        if (!group.isEmpty()) {
            text.add(key, group);
        }
    }

    private void addIfAny(String key, List<?> list) {
        if (!list.isEmpty()) {
            text.add(key, list);
        }
    }

    private Map<String, Object> wall(SolidRaster raster) {
        var wall = new LinkedHashMap<String, Object>();
        String name = base + "-" + (images.size() + 1) + ".png";
        images.put(name, png(raster));
        wall.put("image", name);
        wall.put("origin", List.of(raster.left(), raster.bottom(), 0L));
        wall.put(
                "resolution",
                raster.cellX() == raster.cellY() ? raster.cellX() : List.of(raster.cellX(), raster.cellY()));
        if (Double.isFinite(raster.highest() - raster.lowest())) {
            heights(wall, raster.lowest(), raster.highest(), Double.NaN);
        }
        if (raster.fenced()) {
            wall.put("fenced", true);
        }
        wall.putAll(difference(raster.surface(), Surface.PLAIN));
        return wall;
    }

    private static byte[] png(SolidRaster raster) {
        int width = raster.width();
        int height = raster.height();
        var image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY);
        byte[] pixels = ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
        for (int row = 0; row < height; row++) {
            int line = (height - 1 - row) * width;
            for (int column = 0; column < width; column++) {
                pixels[line + column] = (byte) (raster.solid().get(row * width + column) ? 0 : 0xff);
            }
        }
        var out = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException("A PNG can't be written to memory.", e);
        }
        return out.toByteArray();
    }

    private static Map<String, Object> thing(Entity thing) {
        var written = new LinkedHashMap<String, Object>();
        written.put("pose", pose(thing.mapFromEntity(), thing.height()));
        Surface surface = thing.blocks().getFirst().surface();
        written.put("body", body(thing.blocks(), surface, true));
        written.putAll(difference(surface, Surface.PLAIN));
        if (thing.givingPower() != 0) {
            written.put("givingPower", thing.givingPower());
        }
        return written;
    }

    private Map<String, Object> robot(RobotSpec robot, String model) {
        var written = new LinkedHashMap<String, Object>();
        if (!robot.role().equals(robot.id())) {
            written.put("role", robot.role());
        }
        written.put("model", model);
        Optional<Entity> body = Optional.ofNullable(scene.robotBodies().get(robot.id()));
        Optional<Pose2d> pose = robot.mapFromBase().or(() -> body.map(Entity::mapFromEntity));
        pose.ifPresent(p -> written.put("pose", pose(p, body.map(Entity::height).orElse(0.0))));
        written.put("color", robot.color());
        Pose2d odometry = scene.odomFromBase().get(robot.id());
        if (odometry != null) {
            written.put("odometry", pose.filter(odometry::equals).isPresent() ? "start" : pose(odometry, 0));
        }
        String program = scene.programs().get(robot.id());
        if (program != null && !program.isEmpty()) {
            written.put("program", program);
        }
        return written;
    }

    /// @param height above the floor [m]
    static List<Object> pose(Pose2d pose, double height) {
        var written = new ArrayList<Object>(List.of(pose.x(), pose.y(), YamlText.degrees(pose.theta())));
        if (height != 0) {
            written.add(height);
        }
        return written;
    }

    /// One piece, or several.
    ///
    /// @param base what others make of pieces that don't say
    /// @param colors whether colors that differ from it are told
    static Map<String, Object> body(List<Block> blocks, Surface base, boolean colors) {
        List<Object> pieces = new ArrayList<>();
        for (Block block : blocks) {
            Surface surface = colors ? block.surface() : block.surface().in(base.color());
            Map<String, Object> piece = piece(block.prism());
            piece.putAll(difference(surface, base));
            block.prism().color().ifPresent(color -> piece.put("color", color.toString()));
            block.carrier().ifPresent(carrier -> piece.put("actuator", carrier));
            pieces.add(piece);
        }
        if (pieces.size() == 1) {
            @SuppressWarnings("unchecked")
            var only = (Map<String, Object>) pieces.getFirst();
            return only;
        }
        return new LinkedHashMap<>(Map.of("pieces", pieces));
    }

    private static Map<String, Object> piece(Prism prism) {
        var piece = new LinkedHashMap<String, Object>();
        switch (prism.shape()) {
            case Shape.Disc disc -> {
                piece.put("radius", disc.radius());
                center(piece, disc.center());
            }
            case Shape.Polygon polygon -> {
                if (!box(piece, polygon)) {
                    piece.put(
                            "outline",
                            polygon.corners().stream()
                                    .map(corner -> List.of(corner.x(), corner.y()))
                                    .toList());
                }
            }
        }
        heights(piece, prism.bottom(), prism.top(), 0);
        return piece;
    }

    private static void center(Map<String, Object> piece, Point2d center) {
        if (!center.equals(new Point2d(0, 0))) {
            piece.put("center", List.of(center.x(), center.y()));
        }
    }

    /// Writes an outline as a box, if that makes the same corners in the same order.
    private static boolean box(Map<String, Object> piece, Shape.Polygon polygon) {
        List<Point2d> corners = polygon.corners();
        if (corners.size() != 4) {
            return false;
        }
        Point2d low = corners.get(0);
        Point2d high = corners.get(2);
        for (double length : shortAndExact(high.x() - low.x())) {
            for (double width : shortAndExact(high.y() - low.y())) {
                for (double x : shortAndExact((low.x() + high.x()) / 2)) {
                    for (double y : shortAndExact((low.y() + high.y()) / 2)) {
                        if (isBox(length, width, new Point2d(x, y), corners)) {
                            piece.put("length", length);
                            piece.put("width", width);
                            center(piece, new Point2d(x, y));
                            return true;
                        }
                    }
                }
            }
        }
        return false;
    }

    private static boolean isBox(double length, double width, Point2d center, List<Point2d> corners) {
        try {
            return length > 0
                    && width > 0
                    && Footprint.box(length, width, center).corners().equals(corners);
        } catch (IllegalArgumentException _) { // too flat
            return false;
        }
    }

    /// A length without the dust of a subtraction, then as it is.
    private static double[] shortAndExact(double length) {
        return new double[] {Math.rint(length * 1e9) / 1e9 + 0.0, length}; // no -0
    }

    /// @param usual bottom that need not be told
    private static void heights(Map<String, Object> piece, double bottom, double top, double usual) {
        if (bottom != usual) {
            piece.put("bottom", bottom);
        }
        piece.put("height", YamlText.inverse(top, height -> bottom + height, top - bottom));
    }

    /// What is to be told of a surface.
    static Map<String, Object> difference(Surface surface, Surface base) {
        var properties = new LinkedHashMap<String, Object>();
        if (!surface.color().equals(base.color())) {
            properties.put("color", surface.color().toString());
        }
        if (surface.obstacle() != base.obstacle()) {
            properties.put("obstacle", surface.obstacle());
        }
        if (surface.reflectance() != base.reflectance()) {
            properties.put("reflectance", surface.reflectance());
        }
        if (surface.blob() != base.blob()) {
            properties.put("blob", surface.blob());
        }
        if (surface.fiducial() != base.fiducial()) {
            properties.put("fiducial", (long) surface.fiducial());
        }
        if (surface.fiducialKey() != base.fiducialKey()) {
            properties.put("key", (long) surface.fiducialKey());
        }
        if (surface.grippable() != base.grippable()) {
            properties.put("grippable", surface.grippable());
        }
        return properties;
    }
}
