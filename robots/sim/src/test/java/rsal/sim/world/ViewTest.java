package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Pose2d;
import rsal.scene.Surface;

class ViewTest {
    private static final Footprint BOX = RandomWorld.box(0.5, 0.4, 0, 0);
    private static final double HEIGHT = 0.3; // of the camera

    /// Asks every piece about every column.
    @Test
    void everyColumnShowsTheNearestThatIsNeitherAboveNorBelowTheImage() {
        int hits = 0;
        int overlooked = 0;
        for (long seed = 0; seed < 200; seed++) {
            var random = new RandomWorld(seed, 0.1, 0.005);
            var world = new World(Walls.of(random.map));
            var bodies = new ArrayList<Body>();
            for (int i = 0; i < 25; i++) {
                double height = i == 0 ? 0 : random.random.nextDouble(-0.5, 2);
                bodies.add(world.add("b" + i, random.chunks(), random.anywhere(), height));
            }
            Body self = bodies.getFirst();
            int columns = random.random.nextInt(1, 100);
            int rows = random.random.nextInt(1, 100);
            double fieldOfView = random.random.nextDouble(0.1, 6.28);
            double reach = random.random.nextDouble(0.5, 6);
            var baseFromCamera = new Pose2d(0.1, 0.1, 1);
            Pose2d from = self.pose().compose(baseFromCamera);
            var sight = new View(baseFromCamera, columns, rows, fieldOfView, HEIGHT).look(world, self, reach);
            double up = fieldOfView / columns * rows / 2;
            for (int i = 0; i < columns; i++) {
                double direction = from.theta() + fieldOfView * (0.5 - (i + 0.5) / columns);
                double dx = Math.cos(direction);
                double dy = Math.sin(direction);
                double range = RandomWorld.ray(world.walls().getFirst(), from.x(), from.y(), dx, dy, reach);
                Surface surface =
                        Double.isFinite(range) ? world.walls().getFirst().surface() : null;
                for (Body body : bodies.subList(1, bodies.size())) {
                    for (Piece piece : body.figure.pieces) {
                        double way = piece.ray(from.x(), from.y(), dx, dy);
                        boolean above = Math.atan2(piece.low() - HEIGHT, way) > up;
                        boolean below = Math.atan2(piece.high() - HEIGHT, way) < -up;
                        overlooked += way <= reach && (above || below) ? 1 : 0;
                        if (way < range && way <= reach && !above && !below) {
                            range = way;
                            surface = piece.surface;
                        }
                    }
                }
                assertThat(sight.range(i)).as("seed %d, column %d", seed, i).isCloseTo(range, within(1e-9));
                assertThat(range == 0 || Objects.equals(sight.surface(i), surface)) // inside of two, either will do
                        .as("seed %d, column %d", seed, i)
                        .isTrue();
                hits += surface == null ? 0 : 1;
            }
        }
        assertThat(hits).isGreaterThan(1000);
        assertThat(overlooked).isGreaterThan(100);
    }

    @Test
    void looksThroughItselfAndWhatItCarries() {
        var world = new World(List.of(), new Extent(0, 0, 10, 10));
        Body self = world.add("self", Chunk.of(BOX), new Pose2d(2, 5, 0), 0);
        Body held = world.add("held", Chunk.of(BOX), new Pose2d(4, 5, 0), 0);
        Body other = world.add("other", Chunk.of(BOX), new Pose2d(8, 5, Math.PI), 0);
        var view = new View(Pose2d.ORIGIN, 1, 1, 0.1, 0);
        assertThat(view.look(world, self, 9).range(0)).isCloseTo(1.75, within(1e-9));
        world.pickUp(held, self);
        world.look();
        assertThat(view.look(world, self, 9).range(0)).isCloseTo(5.75, within(1e-9));
        assertThat(view.look(world, other, 9).range(0)).isCloseTo(3.75, within(1e-9));
        world.carry(held, new Pose2d(5, 5, 0), 0);
        assertThat(view.look(world, other, 9).range(0)).isCloseTo(3.75, within(1e-9));
        world.look();
        assertThat(view.look(world, other, 9).range(0)).isCloseTo(2.75, within(1e-9));
    }
}
