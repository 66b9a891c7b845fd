package rsal.recording.animation;

import java.awt.AWTError;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.RobotView;
import rsal.engine.report.Snapshot;
import rsal.engine.report.Teammate;
import rsal.recording.Playback;
import rsal.scenario.picture.PaintedOutline;

/// Draws a recorded run as it was at one time after the other.
final class RunPainter {
    private static final int CAPTION = 26; // below the map [px]
    private static final Duration TRAIL = Duration.ofSeconds(8);
    private static final double LEAST_RADIUS =
            8; // of a robot, which is drawn larger than it is where it would be smaller [px]
    private static final Color FLOOR = new Color(0xfb, 0xfa, 0xf7);
    private static final Color WALL = new Color(0x3a, 0x40, 0x48);
    private static final Color OUTSIDE = new Color(0xe8, 0xe9, 0xec);
    private static final Color WORDS = new Color(0x30, 0x36, 0x3d);
    private static final int SCAN_ALPHA = 26;
    private static final int TRAIL_ALPHA = 150;

    private final Playback playback;
    private final OccupancyGrid map;
    private final double perMeter; // [px]
    private final int mapHeight; // [px]
    private final BufferedImage background;
    private final AffineTransform pixelsFromMap;
    private final Map<String, Deque<Place>> trails = new HashMap<>(); // by robot, oldest first

    private record Place(Duration time, Point2d mapFromBase) {}

    /// @param longest side [px]
    /// @throws IOException when Java looks for a screen that is named, and can't reach it
    RunPainter(Playback playback, int longest) throws IOException {
        this.playback = playback;
        this.map = playback.plan().map();
        double across = map.width() * map.resolution();
        double up = map.height() * map.resolution();
        this.perMeter = longest / Math.max(across, up);
        int width = Math.max(100, (int) Math.ceil(across * perMeter));
        this.mapHeight = Math.max(1, (int) Math.ceil(up * perMeter));
        this.pixelsFromMap = new AffineTransform(
                perMeter, 0, 0, -perMeter, -map.originX() * perMeter, mapHeight + map.originY() * perMeter);
        this.background = new BufferedImage(width, mapHeight + CAPTION, BufferedImage.TYPE_INT_RGB);
        try {
            drawMap();
        } catch (AWTError | LinkageError e) { // the latter once the former has come
            throw new IOException("The screen can't be reached: " + e.getMessage(), e);
        }
    }

    private void drawMap() {
        Graphics2D graphics = background.createGraphics();
        graphics.setColor(FLOOR);
        graphics.fillRect(0, 0, background.getWidth(), background.getHeight());
        graphics.dispose();
        for (int y = 0; y < mapHeight; y++) {
            for (int x = 0; x < background.getWidth(); x++) {
                byte cell = darkest(x, y);
                if (cell != OccupancyGrid.FREE) {
                    background.setRGB(x, y, (cell == OccupancyGrid.OCCUPIED ? WALL : OUTSIDE).getRGB());
                }
            }
        }
    }

    /// Of the cells that a pixel shows.
    private byte darkest(int x, int y) {
        int left = column(x);
        int top = row(y) + 1;
        return map.darkest(left, Math.min(top - 1, row(y + 1) + 1), Math.max(left + 1, column(x + 1)), top);
    }

    private int column(int x) {
        return (int) Math.floor(x / perMeter / map.resolution());
    }

    private int row(int y) {
        return (int) Math.floor((mapHeight - y) / perMeter / map.resolution() - 1e-9);
    }

    /// Forgets where robots were, to begin at an earlier time.
    void forget() {
        trails.clear();
    }

    /// @param time since the run's start, not before the one of the last picture
    BufferedImage paint(Duration time) throws IOException {
        Snapshot now = playback.at(time);
        var picture = new BufferedImage(background.getWidth(), background.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        graphics.drawImage(background, 0, 0, null);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.clipRect(0, 0, picture.getWidth(), mapHeight);
        now.robots().forEach(robot -> drawScan(graphics, robot));
        now.things().forEach(thing -> drawThing(graphics, thing));
        now.robots().forEach(robot -> drawPaths(graphics, robot, now.time()));
        for (RobotView robot : now.robots()) {
            pose(robot).ifPresent(pose -> drawRobot(graphics, robot, pose, now.team()));
        }
        graphics.setClip(null);
        drawCaption(graphics, now);
        graphics.dispose();
        return picture;
    }

    /// Where it really is, as far as that is known.
    private static Optional<Pose2d> pose(RobotView robot) {
        return robot.gone() ? Optional.empty() : robot.truth().or(() -> estimate(robot));
    }

    private static Optional<Pose2d> estimate(RobotView robot) {
        return robot.estimate().map(Stamped::value).map(PoseEstimate::mapFromBase);
    }

    private static Color color(RobotView robot, int alpha) {
        Rgb rgb = Rgb.parse(robot.color()).orElse(new Rgb(0x60, 0x60, 0x60));
        return new Color(rgb.red(), rgb.green(), rgb.blue(), alpha);
    }

    private void drawScan(Graphics2D graphics, RobotView robot) {
        Optional<Pose2d> pose = pose(robot);
        Optional<LaserScan> scan = robot.scan().map(Stamped::value);
        if (pose.isEmpty() || scan.isEmpty() || scan.get().count() < 2) {
            return;
        }
        LaserScan seen = scan.get();
        Pose2d mapFromLaser = pose.get().compose(seen.baseFromLaser());
        var fan = new Path2D.Double();
        fan.moveTo(mapFromLaser.x(), mapFromLaser.y());
        for (int beam = 0; beam < seen.count(); beam++) {
            double range = Math.min(seen.distance(beam), seen.rangeMax());
            double direction = mapFromLaser.theta() + seen.angle(beam);
            if (range > 0) {
                fan.lineTo(
                        mapFromLaser.x() + range * Math.cos(direction), mapFromLaser.y() + range * Math.sin(direction));
            }
        }
        fan.closePath();
        graphics.setColor(color(robot, SCAN_ALPHA));
        graphics.fill(pixelsFromMap.createTransformedShape(fan));
    }

    private void drawThing(Graphics2D graphics, Standing thing) {
        draw(graphics, thing.body(), thing.mapFromThing(), 1, new Color(0x90, 0x90, 0x90));
    }

    private void drawPaths(Graphics2D graphics, RobotView robot, Duration time) {
        Deque<Place> trail = trails.computeIfAbsent(robot.id(), _ -> new ArrayDeque<>());
        pose(robot).ifPresent(pose -> trail.addLast(new Place(time, pose.position())));
        while (!trail.isEmpty() && trail.getFirst().time().compareTo(time.minus(TRAIL)) < 0) {
            trail.removeFirst();
        }
        graphics.setStroke(new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.setColor(color(robot, TRAIL_ALPHA));
        draw(graphics, trail.stream().map(Place::mapFromBase).toList());
        graphics.setStroke(
                new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {3, 3}, 0));
        draw(graphics, robot.path().points());
    }

    private void draw(Graphics2D graphics, List<Point2d> points) {
        if (points.size() < 2) {
            return;
        }
        var line = new Path2D.Double();
        line.moveTo(points.getFirst().x(), points.getFirst().y());
        points.forEach(point -> line.lineTo(point.x(), point.y()));
        graphics.draw(pixelsFromMap.createTransformedShape(line));
    }

    /// As large as it is, but not too small to be seen.
    private void drawRobot(Graphics2D graphics, RobotView robot, Pose2d mapFromBase, List<Teammate> team) {
        Optional<Teammate> known =
                team.stream().filter(one -> one.spec().id().equals(robot.id())).findFirst();
        double radius = known.map(one -> one.spec().model().footprint().circumscribedRadius())
                .orElse(LEAST_RADIUS / perMeter);
        Solid body = known.map(
                        one -> one.body().orElseGet(() -> one.spec().model().body()))
                .orElseGet(() -> Solid.standing(new rsal.data.Shape.Disc(new Point2d(0, 0), radius), 1));
        double larger = Math.max(1, LEAST_RADIUS / (radius * perMeter));
        draw(graphics, body, mapFromBase, larger, color(robot, 255));
        Pose2d nose = mapFromBase.compose(new Pose2d(1.2 * larger * radius, 0, 0));
        graphics.setStroke(new BasicStroke(1.5f));
        graphics.setColor(Color.BLACK);
        draw(graphics, List.of(mapFromBase.position(), nose.position()));
    }

    /// @param larger how many times larger than it is, around its own middle
    private void draw(Graphics2D graphics, Solid body, Pose2d mapFromBody, double larger, Color color) {
        var pixelsFromBody = new AffineTransform(pixelsFromMap);
        pixelsFromBody.translate(mapFromBody.x(), mapFromBody.y());
        pixelsFromBody.scale(larger, larger);
        pixelsFromBody.translate(-mapFromBody.x(), -mapFromBody.y());
        graphics.setStroke(new BasicStroke(1));
        for (Prism piece : body.pieces()) {
            PaintedOutline.paint(
                    graphics,
                    pixelsFromBody.createTransformedShape(PaintedOutline.of(piece.shape(), mapFromBody)),
                    piece.color().map(rgb -> new Color(rgb.packed())).orElse(color));
        }
    }

    private void drawCaption(Graphics2D graphics, Snapshot now) {
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, mapHeight, background.getWidth(), CAPTION);
        graphics.setColor(WORDS);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        String outcome = now.outcome().map(word -> "   " + word).orElse("");
        graphics.drawString(
                String.format(
                        Locale.ROOT,
                        "%s:%s   %.1f s%s",
                        playback.plan().scenario().name(),
                        playback.plan().configuration(),
                        now.time().toMillis() / 1e3,
                        outcome),
                8,
                mapHeight + 18);
    }
}
