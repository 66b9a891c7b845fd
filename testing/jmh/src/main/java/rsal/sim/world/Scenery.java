package rsal.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import rsal.bench.place.Cave;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Robots in a cave, for benchmarks.
final class Scenery {
    static final OccupancyGrid CAVE = Cave.draw(128, 0.05, 1);

    final RasterWalls walls = RasterWalls.of(CAVE);
    final World world = new World(walls);
    final List<Body> robots = new ArrayList<>();

    Scenery(int count) {
        var random = new SplittableRandom(1);
        List<CollisionShape> body = CollisionShape.of(Footprint.box(0.44, 0.38, new Point2d(0, 0)));
        while (robots.size() < count) {
            var pose = new Pose2d(random.nextDouble(-64, 64), random.nextDouble(-64, 64), random.nextDouble(-3, 3));
            if (walls.emptyAround(pose.x(), pose.y()) > 0.4 && world.hasRoom(body, pose, 0.2)) {
                robots.add(world.add("r" + robots.size(), body, pose, 0));
            }
        }
    }
}
