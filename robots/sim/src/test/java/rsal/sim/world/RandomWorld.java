package rsal.sim.world;

import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.scene.Surface;

/// Worlds made from a seed, and slow ways to look at them.
final class RandomWorld {
    final SplittableRandom random;
    final OccupancyGrid map;

    /// @param density share of cells that are occupied
    RandomWorld(long seed, double resolution, double density) {
        random = new SplittableRandom(seed);
        int width = random.nextInt(10, 80);
        int height = random.nextInt(10, 80);
        var cells = new byte[width * height];
        for (int i = 0; i < cells.length; i++) {
            cells[i] = random.nextDouble() < density ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        map = new OccupancyGrid(
                width, height, resolution, random.nextDouble(-50, 50), random.nextDouble(-50, 50), cells);
    }

    Pose2d anywhere() {
        return new Pose2d(
                map.originX() + random.nextDouble() * map.width() * map.resolution(),
                map.originY() + random.nextDouble() * map.height() * map.resolution(),
                random.nextDouble(-Math.PI, Math.PI));
    }

    /// One to four chunks, of which sensors and others see some.
    List<CollisionShape> chunks() {
        var chunks = new ArrayList<CollisionShape>();
        for (int i = random.nextInt(4); i >= 0; i--) {
            var center = new Point2d(random.nextDouble(-0.3, 0.3), random.nextDouble(-0.3, 0.3));
            double bottom = random.nextDouble(-0.5, 0.5);
            var surface = new Surface(
                    Rgb.of(random.nextInt()), random.nextBoolean(), random.nextInt(3) - 1, true, 0, 0, false);
            chunks.add(
                    random.nextBoolean()
                            ? new CollisionShape.Cylinder(
                                    center, random.nextDouble(0.05, 0.3), bottom, bottom + 0.7, surface)
                            : new CollisionShape.Prism(
                                    new ConvexOutline(Footprint.box(random.nextDouble(0.05, 0.5), 0.2, center)
                                            .corners()),
                                    bottom,
                                    bottom + 0.7,
                                    surface));
        }
        return chunks;
    }

    /// A box that is larger by a margin on each side.
    static Footprint box(double length, double width, double offset, double margin) {
        return Footprint.box(length + 2 * margin, width + 2 * margin, new Point2d(offset, 0));
    }

    static Path2D shape(Footprint footprint, Pose2d pose) {
        var path = new Path2D.Double();
        for (Point2d corner : footprint.corners()) {
            Point2d point = pose.transform(corner);
            if (path.getCurrentPoint() == null) {
                path.moveTo(point.x(), point.y());
            } else {
                path.lineTo(point.x(), point.y());
            }
        }
        path.closePath();
        return path;
    }

    /// Whether a shape meets an occupied cell or leaves the map.
    boolean hits(Path2D shape) {
        var bounds = shape.getBounds2D();
        int lastColumn = map.column(bounds.getMaxX());
        int lastRow = map.row(bounds.getMaxY());
        for (int row = map.row(bounds.getMinY()); row <= lastRow; row++) {
            for (int column = map.column(bounds.getMinX()); column <= lastColumn; column++) {
                boolean solid = !map.contains(column, row) || map.at(column, row) == OccupancyGrid.OCCUPIED;
                double x = map.originX() + column * map.resolution();
                double y = map.originY() + row * map.resolution();
                if (solid && shape.intersects(x, y, map.resolution(), map.resolution())) {
                    return true;
                }
            }
        }
        return false;
    }

    static double ray(RasterWalls walls, double x, double y, double dx, double dy, double reach) {
        return ranges(List.of(walls), reach, new double[] {x, y, dx, dy, Double.POSITIVE_INFINITY})[0];
    }

    /// Casts rays that are on their way together.
    ///
    /// @param wanted of each its place, its direction, and the range at which it has met something already
    static double[] ranges(List<RasterWalls> all, double reach, double[]... wanted) {
        var rays = Rays.ofThisThread(wanted.length);
        for (int i = 0; i < wanted.length; i++) {
            rays.x[i] = wanted[i][0];
            rays.y[i] = wanted[i][1];
            rays.dx[i] = wanted[i][2];
            rays.dy[i] = wanted[i][3];
            rays.range[i] = wanted[i][4];
        }
        all.forEach(walls -> walls.end(rays, reach));
        return Arrays.copyOf(rays.range, wanted.length);
    }
}
