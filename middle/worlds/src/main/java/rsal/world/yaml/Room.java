package rsal.world.yaml;

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
    private static final double LARGE = 50; // radius of a circle that is kept aside, lest all squares be near it [m]
    private static final long MOST_LOOKS = 200_000_000; // at squares and circles

    private final OccupancyGrid map;
    private final long mostLooks;
    private final float[] distances; // to the nearest cell that is not free, by cell [cells]
    private final Map<Bucket, List<Circle>> buckets = new HashMap<>();
    private final List<Circle> large = new ArrayList<>();
    private double largest; // radius of a circle in a bucket [m]
    private long looks;

    private record Circle(double x, double y, double radius, boolean robot) {}

    private record Bucket(long column, long row) {}

    /// What is looked for: a circle, and how far it must be from others [m].
    private record Wanted(double x, double y, double radius, double gap, double robotGap) {
        boolean fits(List<Circle> others) {
            for (Circle other : others) {
                double least = radius + other.radius + (other.robot ? robotGap : gap);
                double dx = Math.abs(other.x - x);
                double dy = Math.abs(other.y - y);
                if (dx < least && dy < least && Math.hypot(dx, dy) < least) {
                    return false;
                }
            }
            return true;
        }

        /// How far those may be that are in its way [m].
        double reach(double largest) {
            return radius + largest + Math.max(gap, robotGap);
        }
    }

    Room(OccupancyGrid map) {
        this(map, MOST_LOOKS);
    }

    Room(OccupancyGrid map, long mostLooks) {
        this.map = map;
        this.mostLooks = mostLooks;
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
        var circle = new Circle(x, y, radius, robot);
        if (radius > LARGE) {
            large.add(circle);
        } else {
            buckets.computeIfAbsent(bucket(x, y), _ -> new ArrayList<>()).add(circle);
            largest = Math.max(largest, radius);
        }
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

    /// Whether a circle around a place is far enough from all that is there; no when it would take too long to say.
    ///
    /// @param gap from all but robots [m]
    /// @param robotGap from robots [m]
    boolean isFree(double x, double y, double radius, double gap, double robotGap) {
        int column = map.column(x);
        int row = map.row(y);
        if (isExhausted()
                || !map.contains(column, row)
                || (distances[row * map.width() + column] - 1.5) * map.resolution() < radius + gap) {
            return false;
        }
        var wanted = new Wanted(x, y, radius, gap, robotGap);
        looks += large.size();
        return wanted.fits(large) && fitsBuckets(wanted);
    }

    /// Whether nothing is found any more, as so much was looked at.
    boolean isExhausted() {
        return looks > mostLooks;
    }

    /// Looks at the buckets that are near, or at all, whichever are fewer.
    private boolean fitsBuckets(Wanted wanted) {
        double reach = wanted.reach(largest);
        Bucket first = bucket(wanted.x - reach, wanted.y - reach);
        Bucket last = bucket(wanted.x + reach, wanted.y + reach);
        if ((last.column - first.column + 1) * (last.row - first.row + 1) > buckets.size()) {
            return buckets.values().stream().allMatch(circles -> fits(wanted, circles));
        }
        for (long column = first.column; column <= last.column; column++) {
            for (long row = first.row; row <= last.row; row++) {
                if (!fits(wanted, buckets.getOrDefault(new Bucket(column, row), List.of()))) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean fits(Wanted wanted, List<Circle> circles) {
        looks += 1 + circles.size();
        return wanted.fits(circles);
    }

    private static Bucket bucket(double x, double y) {
        return new Bucket((long) Math.floor(x / BUCKET), (long) Math.floor(y / BUCKET));
    }
}
