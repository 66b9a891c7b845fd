package rsal.scenario.picture;

import java.awt.AWTError;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;

/// A world from above: floor plans dark, things and robots in their colors, the higher over the lower, what range
/// sensors see as pale fans, and a bar that tells the scale.
public final class WorldPicture {
    private static final int SHORTEST = 200; // side [px]
    private static final int BELOW = 40; // for the bar [px]
    private static final double MOST_PER_METER = 200; // [px]
    private static final double RAYS_APART = Math.toRadians(0.5);
    private static final int MANY = 200; // robots; fans of more would hide the world
    private static final Color WALL = new Color(0x33, 0x33, 0x33);
    private static final Color LASER = new Color(0, 90, 255, 22);
    private static final Color SONAR = new Color(0, 160, 60, 90);

    private final Scene scene;
    private final List<RobotSpec> robots;
    private final double perMeter;
    private final BufferedImage image;
    private final Graphics2D graphics;
    private final AffineTransform pixelsFromMap;

    private WorldPicture(Scene scene, List<RobotSpec> robots, int longest) {
        this.scene = scene;
        this.robots = robots;
        OccupancyGrid map = scene.map();
        double across = map.width() * map.resolution();
        double up = map.height() * map.resolution();
        perMeter = Math.min(MOST_PER_METER, longest / Math.max(across, up));
        int width = Math.max(SHORTEST, (int) Math.ceil(across * perMeter));
        int height = Math.max(1, (int) Math.ceil(up * perMeter));
        image = new BufferedImage(width, height + BELOW, BufferedImage.TYPE_INT_RGB);
        graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
        pixelsFromMap = new AffineTransform(
                perMeter, 0, 0, -perMeter, -map.originX() * perMeter, height + map.originY() * perMeter);
        draw();
        graphics.dispose();
    }

    /// A world as it is read.
    ///
    /// @param longest side [px]
    /// @return a PNG
    /// @throws UncheckedIOException when Java looks for a screen that is named, and can't reach it
    public static byte[] of(Scene scene, int longest) {
        return png(() -> new WorldPicture(scene, scene.robots(), longest));
    }

    /// A run before its first step.
    ///
    /// @param longest side [px]
    /// @return a PNG
    /// @throws UncheckedIOException when Java looks for a screen that is named, and can't reach it
    public static byte[] of(RunPlan plan, int longest) {
        List<RobotSpec> robots =
                plan.robots().stream().map(RunPlan.PlannedRobot::spec).toList();
        return png(() -> new WorldPicture(plan.scene(), robots, longest));
    }

    private static byte[] png(Supplier<WorldPicture> picture) {
        var out = new ByteArrayOutputStream();
        try {
            if (!ImageIO.write(picture.get().image, "png", out)) {
                throw new IOException("This Java writes no PNG.");
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (AWTError | LinkageError e) { // the latter once the former has come
            throw new UncheckedIOException(new IOException("The screen can't be reached: " + e.getMessage(), e));
        }
        return out.toByteArray();
    }

    private void draw() {
        drawStanding();
        if (robots.size() <= MANY) {
            List<Entity> bodies = Stream.concat(
                            scene.things().stream(), robots.stream().flatMap(robot -> bodyOf(robot).stream()))
                    .toList();
            var sight = new WorldSight(scene.walls(), bodies);
            robots.forEach(robot -> drawFans(robot, sight));
        }
        for (RobotSpec robot : robots) {
            bodyOf(robot).ifPresent(this::draw);
            robot.mapFromBase()
                    .ifPresent(
                            pose -> drawHeading(pose, robot.model().footprint().circumscribedRadius()));
        }
        drawBar();
    }

    /// Floor plans and things, the higher over the lower, as they hide each other.
    private void drawStanding() {
        record Standing(double top, Runnable drawing) {}
        Stream<Standing> walls = scene.walls().stream().map(wall -> new Standing(wall.highest(), () -> draw(wall)));
        Stream<Standing> blocks = scene.things().stream()
                .flatMap(thing -> thing.blocks().stream()
                        .map(block -> new Standing(
                                thing.height() + block.prism().top(), () -> draw(block, thing.mapFromEntity()))));
        Stream.concat(walls, blocks)
                .sorted(Comparator.comparingDouble(Standing::top))
                .forEach(standing -> standing.drawing.run());
    }

    private Optional<Entity> bodyOf(RobotSpec robot) {
        return Optional.ofNullable(scene.robotBodies().get(robot.id()))
                .or(() -> robot.mapFromBase()
                        .map(pose -> new Entity(
                                robot.id(),
                                Entity.blocks(
                                        robot.model().body(),
                                        Rgb.parse(robot.color()).orElse(Surface.PLAIN.color())),
                                pose,
                                0)));
    }

    private void draw(SolidRaster raster) {
        graphics.setColor(WALL);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
        for (int row = 0; row < raster.height(); row++) {
            int begin = row * raster.width();
            int end = begin + raster.width();
            int from = raster.solid().nextSetBit(begin);
            while (from >= 0 && from < end) {
                int to = Math.min(end, raster.solid().nextClearBit(from));
                var run = new Rectangle2D.Double(
                        raster.left() + (from - begin) * raster.cellX(),
                        raster.bottom() + row * raster.cellY(),
                        (to - from) * raster.cellX(),
                        raster.cellY());
                var bounds = pixelsFromMap.createTransformedShape(run).getBounds(); // at least a pixel
                graphics.fillRect(bounds.x, bounds.y, bounds.width, bounds.height);
                from = raster.solid().nextSetBit(to);
            }
        }
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    private void draw(Entity robot) {
        Entity.lowestFirst(robot.blocks()).forEach(block -> draw(block, robot.mapFromEntity()));
    }

    private void draw(Block block, Pose2d mapFromEntity) {
        graphics.setStroke(new BasicStroke(1));
        Shape outline = PaintedOutline.of(block.prism().shape(), mapFromEntity);
        PaintedOutline.paint(
                graphics,
                pixelsFromMap.createTransformedShape(outline),
                new Color(block.surface().color().packed()));
    }

    private void drawHeading(Pose2d pose, double radius) {
        Pose2d nose = pose.compose(new Pose2d(1.3 * Math.max(radius, 4 / perMeter), 0, 0));
        graphics.setStroke(new BasicStroke(1.5f));
        graphics.setColor(Color.BLACK);
        graphics.draw(pixelsFromMap.createTransformedShape(new Line2D.Double(pose.x(), pose.y(), nose.x(), nose.y())));
    }

    private void drawFans(RobotSpec robot, WorldSight sight) {
        bodyOf(robot)
                .ifPresent(body -> robot.model()
                        .sensors()
                        .forEach((name, part) -> drawFan(
                                part, body, body.height() + robot.model().level(name), sight)));
    }

    private void drawFan(Part part, Entity body, double height, WorldSight sight) {
        graphics.setStroke(new BasicStroke(1));
        switch (part) {
            case Part.Laser laser -> {
                Pose2d eye = body.mapFromEntity().compose(laser.baseFromLaser());
                double extent = laser.angleIncrement() * (laser.samples() - 1);
                int rays = 1 + (int) Math.ceil(extent / RAYS_APART);
                double apart = extent / Math.max(1, rays - 1);
                var fan = new WorldSight.Fan(eye, height, laser.angleMin(), apart, rays, laser.rangeMax());
                double[] ranges = sight.ranges(fan, body.name());
                var outline = new Path2D.Double();
                outline.moveTo(eye.x(), eye.y());
                for (int ray = 0; ray < rays; ray++) {
                    double direction = fan.direction(ray);
                    outline.lineTo(
                            eye.x() + ranges[ray] * Math.cos(direction), eye.y() + ranges[ray] * Math.sin(direction));
                }
                outline.closePath();
                graphics.setColor(LASER);
                graphics.fill(pixelsFromMap.createTransformedShape(outline));
            }
            case Part.Sonars sonars -> {
                graphics.setColor(SONAR);
                for (Pose2d baseFromSonar : sonars.baseFromSensors()) {
                    Pose2d eye = body.mapFromEntity().compose(baseFromSonar);
                    double range =
                            sight.ranges(new WorldSight.Fan(eye, height, 0, 0, 1, sonars.rangeMax()), body.name())[0];
                    Point2d end = eye.transform(new Point2d(range, 0));
                    graphics.draw(pixelsFromMap.createTransformedShape(
                            new Line2D.Double(eye.x(), eye.y(), end.x(), end.y())));
                }
            }
            default -> {}
        }
    }

    private void drawBar() {
        double length = niceLength(image.getWidth() / 4.0 / perMeter);
        int pixels = (int) Math.round(length * perMeter);
        int y = image.getHeight() - BELOW / 2;
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, image.getHeight() - BELOW, image.getWidth(), BELOW);
        graphics.setColor(Color.BLACK);
        graphics.setStroke(new BasicStroke(2));
        graphics.drawLine(10, y, 10 + pixels, y);
        graphics.drawLine(10, y - 5, 10, y + 5);
        graphics.drawLine(10 + pixels, y - 5, 10 + pixels, y + 5);
        graphics.drawString(String.format(Locale.ROOT, length < 1 ? "%.1f m" : "%.0f m", length), 18 + pixels, y + 5);
    }

    /// 1, 2 or 5 times a power of ten, at most as long.
    private static double niceLength(double most) {
        double power = Math.pow(10, Math.floor(Math.log10(most)));
        return power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
    }
}
