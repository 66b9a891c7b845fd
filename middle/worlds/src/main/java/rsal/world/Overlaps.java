package rsal.world;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.SolidRaster;

/// Finds robots that start inside of something that is in their way at their height. Those that touch it don't.
public final class Overlaps {
    private static final double LEAST = 1e-4; // that counts [m²]; rounding leaves less
    private static final double FLATNESS = 1e-4; // how far from a circle the outline may be that stands for it [m]

    private Overlaps() {}

    /// A robot that starts inside of something.
    ///
    /// @param other what that is: a thing or a robot named before; empty for a wall
    public record Overlap(Entity robot, Optional<Entity> other) {
        /// What to try.
        public static final String REMEDY = "Give it another 'pose', or it may be stuck there.";

        /// For people: `Robot (r1) starts inside (box).`
        public String message() {
            return "Robot '%s' starts inside %s."
                    .formatted(
                            robot.name(),
                            other.map(it -> "'%s'".formatted(it.name())).orElse("a wall"));
        }
    }

    /// What robots start inside of, in the order of the robots. Of several that one is in it tells of one: a wall
    /// before all else.
    public static List<Overlap> of(List<SolidRaster> walls, List<Entity> things, List<Entity> robots) {
        var found = new TreeMap<Integer, Overlap>();
        var ofRobots = new ArrayList<Piece>();
        for (int i = 0; i < robots.size(); i++) {
            Entity robot = robots.get(i);
            List<Piece> own = pieces(robot, i);
            ofRobots.addAll(own);
            if (own.stream().anyMatch(piece -> walls.stream().anyMatch(piece::isIn))) {
                found.put(i, new Overlap(robot, Optional.empty()));
            }
        }
        var all = new ArrayList<>(ofRobots);
        things.forEach(thing -> all.addAll(pieces(thing, Piece.THING)));
        all.sort(Comparator.comparingDouble(piece -> piece.bounds.getMinX()));
        sweep(all, found);
        return List.copyOf(found.values());
    }

    /// From left to right, so that only those side by side are compared.
    private static void sweep(List<Piece> all, Map<Integer, Overlap> found) {
        var robots = new ArrayList<Piece>(); // that reach as far as we are
        var things = new ArrayList<Piece>();
        for (Piece piece : all) {
            robots.removeIf(other -> other.bounds.getMaxX() <= piece.bounds.getMinX());
            robots.forEach(robot -> compare(robot, piece, found));
            if (piece.isThing()) {
                things.add(piece);
            } else {
                things.removeIf(other -> other.bounds.getMaxX() <= piece.bounds.getMinX());
                things.forEach(thing -> compare(piece, thing, found));
                robots.add(piece);
            }
        }
    }

    private static void compare(Piece robot, Piece other, Map<Integer, Overlap> found) {
        Piece later = robot.number > other.number ? robot : other;
        Piece before = later == robot ? other : robot;
        if (later.number != before.number && !found.containsKey(later.number) && later.meets(before)) {
            found.put(later.number, new Overlap(later.owner, Optional.of(before.owner)));
        }
    }

    private static List<Piece> pieces(Entity entity, int number) {
        var placed = AffineTransform.getTranslateInstance(
                entity.mapFromEntity().x(), entity.mapFromEntity().y());
        placed.rotate(entity.mapFromEntity().theta());
        return entity.blocks().stream()
                .filter(block -> block.surface().obstacle())
                .map(block -> new Piece(entity, number, block, placed))
                .toList();
    }

    /// A block of an entity, where that is.
    private static final class Piece {
        static final int THING = -1;

        private final Entity owner;
        private final int number; // of the robot; THING
        private final double bottom; // above the floor [m]
        private final double top;
        private final Shape shape;
        private final Rectangle2D bounds;
        private @Nullable Area area; // as soon as somebody asks

        Piece(Entity owner, int number, Block block, AffineTransform placed) {
            this.owner = owner;
            this.number = number;
            bottom = owner.height() + block.prism().bottom();
            top = owner.height() + block.prism().top();
            shape = placed.createTransformedShape(shape(block.prism().shape()));
            bounds = shape.getBounds2D();
        }

        private static Shape shape(rsal.data.Shape shape) {
            return switch (shape) {
                case rsal.data.Shape.Disc disc ->
                    new Ellipse2D.Double(
                            disc.center().x() - disc.radius(),
                            disc.center().y() - disc.radius(),
                            2 * disc.radius(),
                            2 * disc.radius());
                case rsal.data.Shape.Polygon polygon -> {
                    var path = new Path2D.Double();
                    for (Point2d corner : polygon.corners()) {
                        if (path.getCurrentPoint() == null) {
                            path.moveTo(corner.x(), corner.y());
                        } else {
                            path.lineTo(corner.x(), corner.y());
                        }
                    }
                    path.closePath();
                    yield path;
                }
            };
        }

        boolean isThing() {
            return number == THING;
        }

        boolean meets(Piece other) {
            if (!(bottom < other.top && other.bottom < top && bounds.intersects(other.bounds))) {
                return false;
            }
            return common(other.area()) > LEAST;
        }

        boolean isIn(SolidRaster walls) {
            if (!walls.surface().obstacle() || !(bottom < walls.highest() && walls.lowest() < top)) {
                return false;
            }
            int first = Math.max(0, cell(bounds.getMinX() - walls.left(), walls.cellX()));
            int last = Math.min(walls.width() - 1, cell(bounds.getMaxX() - walls.left(), walls.cellX()));
            int firstRow = Math.max(0, cell(bounds.getMinY() - walls.bottom(), walls.cellY()));
            int lastRow = Math.min(walls.height() - 1, cell(bounds.getMaxY() - walls.bottom(), walls.cellY()));
            double inside = 0;
            for (int row = firstRow; row <= lastRow; row++) {
                int end = row * walls.width() + last;
                int at = walls.solid().nextSetBit(row * walls.width() + first);
                for (; at >= 0 && at <= end; at = walls.solid().nextSetBit(at + 1)) {
                    double x = walls.left() + (at - row * walls.width()) * walls.cellX();
                    double y = walls.bottom() + row * walls.cellY();
                    if (shape.intersects(x, y, walls.cellX(), walls.cellY())) {
                        inside += common(new Area(new Rectangle2D.Double(x, y, walls.cellX(), walls.cellY())));
                    }
                    if (inside > LEAST) {
                        return true;
                    }
                }
            }
            return false;
        }

        private static int cell(double distance, double size) {
            return (int) Math.floor(distance / size);
        }

        private Area area() {
            Area its = area;
            if (its == null) {
                its = new Area(shape);
                area = its;
            }
            return its;
        }

        /// What is in both [m²].
        private double common(Area other) {
            var common = new Area(area());
            common.intersect(other);
            return size(common);
        }

        /// What an area encloses [m²].
        private static double size(Area area) {
            double twice = 0;
            double[] point = new double[6];
            double startX = 0;
            double startY = 0;
            double x = 0;
            double y = 0;
            for (PathIterator path = area.getPathIterator(null, FLATNESS); !path.isDone(); path.next()) {
                int kind = path.currentSegment(point);
                double toX = kind == PathIterator.SEG_CLOSE ? startX : point[0];
                double toY = kind == PathIterator.SEG_CLOSE ? startY : point[1];
                if (kind == PathIterator.SEG_MOVETO) {
                    startX = toX;
                    startY = toY;
                } else {
                    twice += x * toY - toX * y;
                }
                x = toX;
                y = toY;
            }
            return Math.abs(twice) / 2;
        }
    }
}
