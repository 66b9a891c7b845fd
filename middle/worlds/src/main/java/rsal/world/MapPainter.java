package rsal.world;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;

/// Draws the map of a world for robots and people: what stays where it is, is in the way or seen by rangers, and is
/// neither flat on the floor nor above all robots. A cell is occupied if any of that reaches into it.
public final class MapPainter {
    private static final double FINEST = 0.05; // side of a cell [m]
    private static final long MOST_CELLS = 16_000_000;
    private static final long MOST_WORK = 20_000_000_000L; // cells drawn, of bodies one upon another
    private static final long PER_STEP = 50; // a step along an edge takes as long as so many cells in a row
    private static final double MARGIN = 0.5; // around all that is there [m]
    private static final double FLAT = 0.05; // [m]; lasers look over what is lower
    private static final double HAIR = 1e-6; // [cells]; what only touches a cell does not reach into it

    private static final double FARTHEST = 100_000; // from one end to the other [m]

    private final List<SolidRaster> walls;
    private final List<Entity> things;
    private final List<Entity> robots;
    private final double reach;
    private long work;
    private double left = Double.POSITIVE_INFINITY;
    private double bottom = Double.POSITIVE_INFINITY;
    private double right = Double.NEGATIVE_INFINITY;
    private double top = Double.NEGATIVE_INFINITY;

    /// The world reaches too far, or there is too much in it.
    public static final class TooLarge extends RuntimeException {
        private static final long serialVersionUID = 1;

        TooLarge(String message) {
            super(message);
        }
    }

    /// @param robots which are in the map's extent, but not drawn
    public MapPainter(List<SolidRaster> walls, List<Entity> things, List<Entity> robots) {
        this.walls = walls;
        this.things = things;
        this.robots = robots;
        this.reach = robots.stream()
                .mapToDouble(robot -> robot.height()
                        + robot.blocks().stream()
                                .mapToDouble(block -> block.prism().top())
                                .max()
                                .orElse(FLAT))
                .max()
                .orElse(1);
    }

    /// Makes the map reach as far as other things that it does not show.
    public MapPainter around(List<Entity> others) {
        others.forEach(this::include);
        return this;
    }

    /// Makes the map reach as far as an area [m].
    public MapPainter around(double left, double bottom, double right, double top) {
        include(left, bottom);
        include(right, top);
        return this;
    }

    /// @throws TooLarge when there can be no map of all that is there
    public OccupancyGrid map() {
        measure();
        if (!(right - left <= FARTHEST && top - bottom <= FARTHEST)) {
            throw new TooLarge("The world is %.3g m large; at most %.0f m can be simulated."
                    .formatted(Math.max(right - left, top - bottom), FARTHEST));
        }
        double resolution = resolution(right - left + 3 * MARGIN, top - bottom + 3 * MARGIN);
        Pose2d aligned = aligned();
        double originX = aligned.x() + Math.floor((left - MARGIN - aligned.x()) / resolution) * resolution;
        double originY = aligned.y() + Math.floor((bottom - MARGIN - aligned.y()) / resolution) * resolution;
        int width = (int) Math.ceil((right + MARGIN - originX) / resolution);
        int height = (int) Math.ceil((top + MARGIN - originY) / resolution);
        var map = new OccupancyGrid(width, height, resolution, originX, originY, new byte[width * height]);
        for (SolidRaster raster : walls) {
            if (counts(raster.surface(), raster.lowest(), raster.highest())) {
                paint(map, raster);
            }
        }
        for (Entity thing : things) {
            for (Block block : thing.blocks()) {
                double low = thing.height() + block.prism().bottom();
                double high = thing.height() + block.prism().top();
                if (counts(block.surface(), low, high)) {
                    paint(map, block.prism().shape(), thing.mapFromEntity());
                }
            }
        }
        return map;
    }

    /// @param across the map [m]
    /// @param up the map [m]
    private static double resolution(double across, double up) {
        double coarse = Math.sqrt(across * up / MOST_CELLS);
        return FINEST * Math.max(1, Math.ceil(coarse / FINEST));
    }

    /// The corner of the largest floor plan: on its cells the map's shall lie, or walls would grow thicker.
    private Pose2d aligned() {
        SolidRaster largest = null;
        for (SolidRaster raster : walls) {
            if (largest == null
                    || (long) raster.width() * raster.height() > (long) largest.width() * largest.height()) {
                largest = raster;
            }
        }
        return largest == null ? Pose2d.ORIGIN : new Pose2d(largest.left(), largest.bottom(), 0);
    }

    private boolean counts(Surface surface, double low, double high) {
        boolean there = surface.obstacle() || (surface.seenByRangers() && high >= FLAT);
        return there && !surface.grippable() && low < reach && high > 0;
    }

    private void measure() {
        for (SolidRaster raster : walls) {
            include(raster.left(), raster.bottom());
            include(
                    raster.left() + raster.width() * raster.cellX(),
                    raster.bottom() + raster.height() * raster.cellY());
        }
        things.forEach(this::include);
        robots.forEach(this::include);
        if (left > right) {
            include(0, 0); // an empty world
        }
    }

    private void include(Entity entity) {
        include(entity.mapFromEntity().x(), entity.mapFromEntity().y());
        for (Block block : entity.blocks()) {
            include(block.prism().shape(), entity.mapFromEntity());
        }
    }

    private void include(Shape shape, Pose2d mapFromEntity) {
        switch (shape) {
            case Shape.Polygon polygon -> {
                for (Point2d corner : polygon.corners()) {
                    Point2d placed = mapFromEntity.transform(corner);
                    include(placed.x(), placed.y());
                }
            }
            case Shape.Disc disc -> {
                Point2d center = mapFromEntity.transform(disc.center());
                include(center.x() - disc.radius(), center.y() - disc.radius());
                include(center.x() + disc.radius(), center.y() + disc.radius());
            }
        }
    }

    private void include(double x, double y) {
        left = Math.min(left, x);
        bottom = Math.min(bottom, y);
        right = Math.max(right, x);
        top = Math.max(top, y);
    }

    private void paint(OccupancyGrid map, SolidRaster raster) {
        BitSet solid = raster.solid();
        for (int row = 0; row < raster.height(); row++) {
            double low = raster.bottom() + row * raster.cellY();
            int end = (row + 1) * raster.width();
            int from = solid.nextSetBit(row * raster.width());
            while (from >= 0 && from < end) {
                int to = Math.min(end, solid.nextClearBit(from));
                double first = raster.left() + (from - row * raster.width()) * raster.cellX();
                double last = raster.left() + (to - row * raster.width()) * raster.cellX();
                fill(map, first, low, last, low + raster.cellY());
                from = solid.nextSetBit(to);
            }
        }
    }

    private void fill(OccupancyGrid map, double left, double bottom, double right, double top) {
        double r = map.resolution();
        int firstColumn = Math.max(0, (int) Math.floor((left - map.originX()) / r + HAIR));
        int lastColumn = Math.min(map.width() - 1, (int) Math.ceil((right - map.originX()) / r - HAIR) - 1);
        int firstRow = Math.max(0, (int) Math.floor((bottom - map.originY()) / r + HAIR));
        int lastRow = Math.min(map.height() - 1, (int) Math.ceil((top - map.originY()) / r - HAIR) - 1);
        for (int row = firstRow; row <= lastRow && firstColumn <= lastColumn; row++) {
            occupy(map, row, firstColumn, lastColumn);
        }
    }

    private void paint(OccupancyGrid map, Shape shape, Pose2d mapFromEntity) {
        switch (shape) {
            case Shape.Polygon polygon -> {
                List<Point2d> corners =
                        polygon.corners().stream().map(mapFromEntity::transform).toList();
                paintEdges(map, corners);
                paintInside(map, corners);
            }
            case Shape.Disc disc -> paintDisc(map, mapFromEntity.transform(disc.center()), disc.radius());
        }
    }

    /// All cells of which the nearest point to the middle is inside.
    private void paintDisc(OccupancyGrid map, Point2d center, double radius) {
        double r = map.resolution();
        int lastRow = Math.min(map.height() - 1, map.row(center.y() + radius));
        for (int row = Math.max(0, map.row(center.y() - radius)); row <= lastRow; row++) {
            double low = map.originY() + row * r;
            double up = Math.max(0, Math.max(low - center.y(), center.y() - (low + r)));
            double half = Math.sqrt(Math.max(0, radius * radius - up * up));
            fill(map, center.x() - half, low, center.x() + half, low + r);
        }
    }

    /// All cells that the outline passes, a hair inside of it.
    private void paintEdges(OccupancyGrid map, List<Point2d> corners) {
        double hair = HAIR * map.resolution();
        for (int i = 0; i < corners.size(); i++) {
            Point2d from = corners.get(i);
            Point2d to = corners.get((i + 1) % corners.size());
            double length = from.distanceTo(to);
            double dx = (to.x() - from.x()) / length;
            double dy = (to.y() - from.y()) / length;
            int steps = (int) Math.ceil(length / (map.resolution() / 4));
            count(PER_STEP * steps);
            for (int k = 0; k <= steps; k++) {
                double along =
                        Math.clamp(length * k / steps, Math.min(hair, length / 2), Math.max(length - hair, length / 2));
                int column = map.column(from.x() + along * dx - hair * dy);
                int row = map.row(from.y() + along * dy + hair * dx);
                if (map.contains(column, row)) {
                    map.cells()[row * map.width() + column] = OccupancyGrid.OCCUPIED;
                }
            }
        }
    }

    private void occupy(OccupancyGrid map, int row, int first, int last) {
        count(PER_STEP + last - first);
        int begin = row * map.width();
        Arrays.fill(map.cells(), begin + first, begin + last + 1, OccupancyGrid.OCCUPIED);
    }

    private void count(long more) {
        work += more;
        if (work > MOST_WORK) {
            throw new TooLarge("There is more in the world than a map of it can be drawn of.");
        }
    }

    /// All cells whose middle is inside.
    private void paintInside(OccupancyGrid map, List<Point2d> corners) {
        double lowest = corners.stream().mapToDouble(Point2d::y).min().orElseThrow();
        double highest = corners.stream().mapToDouble(Point2d::y).max().orElseThrow();
        int lastRow = Math.min(map.height() - 1, map.row(highest));
        for (int row = Math.max(0, map.row(lowest)); row <= lastRow; row++) {
            double[] crossings = crossings(corners, map.y(row));
            for (int k = 0; k + 1 < crossings.length; k += 2) {
                int first = Math.max(0, (int) Math.ceil((crossings[k] - map.originX()) / map.resolution() - 0.5));
                int last = Math.min(map.width() - 1, (int)
                        Math.floor((crossings[k + 1] - map.originX()) / map.resolution() - 0.5));
                if (first <= last) {
                    occupy(map, row, first, last);
                }
            }
        }
    }

    /// Where an outline crosses a line along x, sorted.
    private static double[] crossings(List<Point2d> corners, double y) {
        double[] crossings = new double[corners.size()];
        int count = 0;
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            if (a.y() > y != b.y() > y) {
                crossings[count++] = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
            }
        }
        double[] found = Arrays.copyOf(crossings, count);
        Arrays.sort(found);
        return found;
    }
}
