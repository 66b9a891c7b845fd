package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

class PieceGridTest {
    private record Circle(double x, double y, double radius) {}

    @Test
    void findsAllThatReachIntoACircleWhateverComesMovesAndGoes() {
        for (long seed = 0; seed < 30; seed++) {
            var random = new SplittableRandom(seed);
            var grid = new PieceGrid(new Extent(-10, -5, random.nextDouble(-9.9, 40), random.nextDouble(-4.9, 45)));
            var found = new PieceGrid.Found();
            var circles = new TreeMap<Integer, Circle>();
            for (int i = 0; i < 500; i++) {
                int circle = random.nextInt(60);
                if (random.nextInt(4) > 0) {
                    var now =
                            new Circle(random.nextDouble(-15, 45), random.nextDouble(-15, 45), random.nextDouble(0, 3));
                    grid.put(circle, now.x, now.y, now.radius);
                    circles.put(circle, now);
                } else if (circles.remove(circle) != null) {
                    grid.remove(circle);
                }
                double x = random.nextDouble(-20, 50);
                double y = random.nextDouble(-20, 50);
                double radius = random.nextDouble(0, 10);
                int count = grid.near(x, y, radius, found);
                assertThat(Arrays.stream(found.slots, 0, count).boxed().toList())
                        .as("seed %d, step %d", seed, i)
                        .doesNotHaveDuplicates()
                        .containsExactlyInAnyOrderElementsOf(slow(circles, x, y, radius));
            }
        }
    }

    private static Set<Integer> slow(Map<Integer, Circle> circles, double x, double y, double radius) {
        var near = new TreeSet<Integer>();
        circles.forEach((name, circle) -> {
            if (Math.hypot(circle.x - x, circle.y - y) < circle.radius + radius) {
                near.add(name);
            }
        });
        return near;
    }
}
