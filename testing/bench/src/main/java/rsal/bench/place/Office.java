package rsal.bench.place;

import java.util.SplittableRandom;
import java.util.function.Predicate;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.settings.Location;

/// The office floor.
public final class Office {
    public static final OccupancyGrid MAP = new Maps(Pioneers.FILES).read("office", Location.of("bench"));

    private Office() {}

    /// A random place on the floor that will do, looking anywhere.
    public static Pose2d place(SplittableRandom random, Predicate<Point2d> willDo) {
        while (true) {
            var place = new Point2d(random.nextDouble(-31, 31), random.nextDouble(-7.5, 7.5));
            if (willDo.test(place)) {
                return new Pose2d(place.x(), place.y(), random.nextDouble(-Math.PI, Math.PI));
            }
        }
    }
}
