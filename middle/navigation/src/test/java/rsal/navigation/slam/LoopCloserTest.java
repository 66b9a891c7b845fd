package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;
import rsal.navigation.scanmatch.Walls;

class LoopCloserTest {
    private static final double PERIOD = 0.6; // m; after which the corridor looks the same
    private static final double RANGE = 4; // m; the corridor's ends are farther away

    private final List<GraphNode> frames = new ArrayList<>();
    private final List<Pose2d> poses = new ArrayList<>();

    private static Walls corridor() {
        var corridor = new Walls().chain(0, 0, 30, 0).chain(0, 2, 30, 2);
        for (double x = 0.5; x < 30; x += PERIOD) {
            corridor.box(x, 0, x + 0.15, 0.15).box(x, 1.85, x + 0.15, 2);
        }
        return corridor;
    }

    @Test
    void wherePlacesLookAlikeItIsTheOneWhereTheRobotShouldBe() {
        int found = 0;
        for (long seed = 1; seed <= 10; seed++) {
            frames.clear();
            poses.clear();
            var closer = new LoopCloser(frames);
            var random = new SplittableRandom(seed);
            for (int i = 0; i < 12; i++) {
                see(closer, new Pose2d(9 + 0.5 * i, 1, 0), 0.5 * i, 0.02, random);
            }
            for (int i = 0; i < 4; i++) { // again, after a long way
                see(closer, new Pose2d(10 + 0.5 * i, 1, 0), 30 + 0.5 * i, i == 0 ? 0.22 : 0.02, random);
            }
            for (Relation loop : closer.look(15, poses)) {
                Pose2d right = poses.get(loop.from()).inverse().compose(poses.get(loop.to()));
                assertThat(loop.fromFromTo().distanceTo(right))
                        .as("seed %d", seed)
                        .isLessThan(0.2);
                found++;
            }
        }
        assertThat(found).isPositive();
    }

    @Test
    void wallsAloneDoNotContradictTheGraph() {
        List<Pose2d> places = List.of(Pose2d.ORIGIN, new Pose2d(5, 0, 0));
        Pose2d reported = new Pose2d(5.1, 0, Math.toRadians(-3));
        Covariance2d alongAWall = Covariance2d.ofDeviations(0.6, 0.07, 0.007);
        Covariance2d inACorner = Covariance2d.ofDeviations(0.02, 0.02, 0.007);

        assertThat(LoopCloser.isSound(loop(reported, alongAWall), places)).isFalse();
        assertThat(LoopCloser.isSound(loop(reported, inACorner), places)).isTrue();
        assertThat(LoopCloser.isSound(loop(new Pose2d(5.1, 0, 0), alongAWall), places))
                .isTrue();
    }

    private static Relation loop(Pose2d fromFromTo, Covariance2d covariance) {
        return new Relation(0, 1, fromFromTo, covariance, Relation.Source.LOOP);
    }

    /// @param deviation of the step to there [m]
    private void see(LoopCloser closer, Pose2d place, double traveled, double deviation, SplittableRandom random) {
        LaserScan scan = corridor().scan(place, 0.01, random);
        frames.add(new GraphNode(place, traveled, scan, Cloud.of(scan, RANGE)));
        poses.add(place);
        int last = poses.size() - 1;
        if (last > 0) {
            Pose2d step = poses.get(last - 1).inverse().compose(place);
            closer.step(last - 1, last, step, Covariance2d.ofDeviations(deviation, deviation, 0.01));
        }
    }
}
