package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;

class NeighborOrderTest {
    private static final int MANY = 500;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void neighborsFollowEachOther(long seed) {
        List<Pose2d> robots = somewhere(seed);
        List<Pose2d> ordered = new NeighborOrder<Pose2d>(Function.identity()).order(robots, 1);
        assertThat(ordered).as("seed %d", seed).containsExactlyInAnyOrderElementsOf(robots);
        assertThat(length(ordered)).as("seed %d", seed).isLessThan(length(robots) / 8);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void anOrderLastsUntilRobotsComeOrGo(long seed) {
        var order = new NeighborOrder<Pose2d>(Function.identity());
        List<Pose2d> robots = somewhere(seed);
        List<Pose2d> ordered = order.order(robots, 1);
        assertThat(order.order(robots, 1)).as("seed %d", seed).isSameAs(ordered);
        List<Pose2d> fewer = robots.subList(0, MANY / 2);
        assertThat(order.order(fewer, 2)).as("seed %d", seed).containsExactlyInAnyOrderElementsOf(fewer);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void anOrderIsMadeAgainAfterAWhile(long seed) {
        var moving = new ArrayList<>(somewhere(seed));
        var followed = new NeighborOrder<Integer>(moving::get);
        List<Integer> indices = IntStream.range(0, MANY).boxed().toList();
        List<Integer> before = followed.order(indices, 1);
        moving.replaceAll(pose -> new Pose2d(pose.y(), -pose.x(), 0));
        List<Integer> later = before;
        for (int i = 0; i < 100; i++) {
            later = followed.order(indices, 1);
        }
        assertThat(later).as("seed %d", seed).isNotEqualTo(before).hasSameElementsAs(before);
    }

    private static List<Pose2d> somewhere(long seed) {
        var random = new SplittableRandom(seed);
        return IntStream.range(0, MANY)
                .mapToObj(_ -> new Pose2d(random.nextDouble(-60, 60), random.nextDouble(-60, 60), 0))
                .toList();
    }

    private static double length(List<Pose2d> poses) {
        return IntStream.range(1, poses.size())
                .mapToDouble(i -> poses.get(i - 1).distanceTo(poses.get(i)))
                .sum();
    }
}
