package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.scene.Surface;

class MarkerSearchTest {
    private static final double HEIGHT = 0.3;
    private static final double STEP = 0.002;

    /// Walks along the line of sight in little steps.
    @Test
    void findsMarkersThatNothingIsInFrontOf() {
        int seen = 0;
        int unseen = 0;
        for (long seed = 0; seed < 150; seed++) {
            var random = new RandomWorld(seed, 0.2, 0.01);
            var world = new World(RasterWalls.of(random.map));
            var bodies = new ArrayList<Body>();
            for (int i = 0; i < 20; i++) {
                bodies.add(world.add("b" + i, post(random, i), random.anywhere(), 0));
            }
            Body self = bodies.getFirst();
            Pose2d from = self.pose();
            double fieldOfView = random.random.nextDouble(0.5, 6);
            double reach = random.random.nextDouble(1, 10);
            boolean allHeights = seed % 2 == 0;
            var expected = new ArrayList<Integer>();
            for (Body body : bodies.subList(1, bodies.size())) {
                Surface surface = body.figure.pieces[0].surface;
                boolean marked = surface.fiducial() != 0 && surface.fiducialKey() == 1;
                double distance = from.distanceTo(body.pose());
                double bearing = Math.abs(from.bearingTo(body.pose().position()));
                if (marked && distance <= reach && bearing <= fieldOfView / 2) {
                    boolean free = isFree(world, bodies, from, body, allHeights);
                    if (free) {
                        expected.add(surface.fiducial());
                    }
                    seen += free ? 1 : 0;
                    unseen += free ? 0 : 1;
                }
            }
            List<MarkerSearch.Found> found =
                    MarkerSearch.markers(world, self, from, HEIGHT, fieldOfView, reach, 1, allHeights);
            assertThat(found)
                    .as("seed %d", seed)
                    .extracting(MarkerSearch.Found::id)
                    .containsExactlyInAnyOrderElementsOf(expected);
            assertThat(found).extracting(MarkerSearch.Found::distance).isSorted();
        }
        assertThat(seen).isGreaterThan(30);
        assertThat(unseen).isGreaterThan(30);
    }

    private static List<CollisionShape> post(RandomWorld random, int id) {
        var marker = new Surface(new Rgb(0, 0, 0), true, 1, true, id % 3 == 0 ? 0 : id, id % 2, false);
        double bottom = random.random.nextDouble(-0.2, 0.5);
        return List.of(new CollisionShape.Cylinder(
                new Point2d(0, 0), random.random.nextDouble(0.05, 0.4), bottom, bottom + 0.5, marker));
    }

    private static boolean isFree(World world, List<Body> bodies, Pose2d from, Body marker, boolean allHeights) {
        Pose2d to = marker.pose();
        double distance = from.distanceTo(to);
        for (double way = 0; way < distance; way += STEP) {
            double x = from.x() + (to.x() - from.x()) * way / distance;
            double y = from.y() + (to.y() - from.y()) * way / distance;
            if (!world.walls().getFirst().isFree(x, y)) {
                return false;
            }
            for (Body body : bodies.subList(1, bodies.size())) {
                PlacedShape piece = body.figure.pieces[0];
                boolean meets = piece.isAt(HEIGHT) || (allHeights && body == marker);
                if (meets && Math.hypot(piece.x() - x, piece.y() - y) <= piece.radius()) {
                    return body == marker;
                }
            }
        }
        return false;
    }
}
