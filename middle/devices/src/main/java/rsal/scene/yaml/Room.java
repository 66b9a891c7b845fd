package rsal.scene.yaml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.data.DistanceTransform;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Shape;
import rsal.scene.Entity;

/// How much room there is around places: from what a map shows, to about a cell, and from circles around all that
/// it does not show.
final class Room {
    private static final double BUCKET = 4; // side of a square that circles are kept by [m]

    private final OccupancyGrid map;
    private final float[] distances; // to the nearest cell that is not free, by cell [cells]
    private final Map<Bucket, List<Circle>> buckets = new HashMap<>();
    private double largest; // radius of a circle [m]

    private record Circle(double x, double y, double radius, boolean robot) {}

    private record Bucket(long column, long row) {}

    Room(OccupancyGrid map) {
        this.map = map;
        this.distances = new float[map.cells().length];
        DistanceTransform.measure(
                map.width(), map.height(), cell -> map.cells()[cell] != OccupancyGrid.FREE, (row, squares) -> {
                    for (int column = 0; column < squares.length; column++) {
                        distances[row * squares.length + column] = (float) Math.sqrt(squares[column]);
                    }
                });
    }

    /// Adds the circle around an entity.
    void add(Entity entity, boolean robot) {
        double x = entity.mapFromEntity().x();
        double y = entity.mapFromEntity().y();
        double radius = radius(entity);
        buckets.computeIfAbsent(bucket(x, y), _ -> new ArrayList<>()).add(new Circle(x, y, radius, robot));
        largest = Math.max(largest, radius);
    }

    /// Of the circle around an entity's origin that holds it [m].
    static double radius(Entity entity) {
        double radius = 0;
        for (var block : entity.blocks()) {
            switch (block.prism().shape()) {
                case Shape.Disc disc ->
                    radius = Math.max(
                            radius, Math.hypot(disc.center().x(), disc.center().y()) + disc.radius());
                case Shape.Polygon polygon -> {
                    for (Point2d corner : polygon.corners()) {
                        radius = Math.max(radius, Math.hypot(corner.x(), corner.y()));
                    }
                }
            }
        }
        return radius;
    }

    /// Whether a circle around a place is far enough from all that is there.
    ///
    /// @param gap from all but robots [m]
    /// @param robotGap from robots [m]
    boolean isFree(double x, double y, double radius, double gap, double robotGap) {
        int column = map.column(x);
        int row = map.row(y);
        if (!map.contains(column, row)
                || (distances[row * map.width() + column] - 1.5) * map.resolution() < radius + gap) {
            return false;
        }
        double reach = radius + largest + Math.max(gap, robotGap);
        for (long c = (long) Math.floor((x - reach) / BUCKET); c <= Math.floor((x + reach) / BUCKET); c++) {
            for (long r = (long) Math.floor((y - reach) / BUCKET); r <= Math.floor((y + reach) / BUCKET); r++) {
                for (Circle other : buckets.getOrDefault(new Bucket(c, r), List.of())) {
                    if (Math.hypot(other.x - x, other.y - y) < radius + other.radius + (other.robot ? robotGap : gap)) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    private static Bucket bucket(double x, double y) {
        return new Bucket((long) Math.floor(x / BUCKET), (long) Math.floor(y / BUCKET));
    }
}
