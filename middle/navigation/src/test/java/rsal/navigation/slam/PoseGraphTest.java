package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.navigation.slam.Relation.Source;

class PoseGraphTest {
    private static final Covariance2d STEP = Covariance2d.ofDeviations(0.05, 0.05, 0.02);
    private static final Covariance2d LOOP = Covariance2d.ofDeviations(0.02, 0.02, 0.01);

    private final List<Pose2d> truth = new ArrayList<>();
    private final List<Pose2d> guess = new ArrayList<>();
    private final List<Relation> relations = new ArrayList<>();

    /// Twice around a square of 20 m, a pose for each meter, with wheels that drift.
    PoseGraphTest() {
        var random = new SplittableRandom(5);
        truth.add(Pose2d.ORIGIN);
        guess.add(Pose2d.ORIGIN);
        for (int i = 1; i < 160; i++) {
            var step = new Pose2d(1, 0, i % 20 == 0 ? Math.PI / 2 : 0);
            var reported = new Pose2d(
                    step.x() + 0.05 * random.nextGaussian(),
                    0.05 * random.nextGaussian(),
                    step.theta() + 0.01 + 0.02 * random.nextGaussian());
            truth.add(truth.getLast().compose(step));
            guess.add(guess.getLast().compose(reported));
            relations.add(new Relation(i - 1, i, reported, STEP, Source.SCANS));
        }
    }

    private void close(int from, int to, Pose2d off) {
        Pose2d fromFromTo = truth.get(from).inverse().compose(truth.get(to)).compose(off);
        relations.add(new Relation(from, to, fromFromTo, LOOP, Source.LOOP));
    }

    private double worst(List<Pose2d> poses) {
        double worst = 0;
        for (int i = 0; i < poses.size(); i++) {
            worst = Math.max(worst, poses.get(i).distanceTo(truth.get(i)));
        }
        return worst;
    }

    @Test
    void loopsTakeTheDriftOut() {
        for (int i = 0; i < 80; i += 5) {
            close(i, i + 80, Pose2d.ORIGIN);
        }
        close(0, 79, Pose2d.ORIGIN);

        PoseGraph.Fit fit = PoseGraph.fitFromAfar(guess, relations);

        assertThat(worst(guess)).isGreaterThan(5);
        assertThat(worst(fit.poses())).isLessThan(1.5);
        assertThat(fit.poses().getFirst()).isEqualTo(Pose2d.ORIGIN);
    }

    @Test
    void wrongLoopsAreScaledDown() {
        for (int i = 0; i < 80; i += 5) {
            close(i, i + 80, Pose2d.ORIGIN);
        }
        close(0, 79, Pose2d.ORIGIN);
        List<Pose2d> right = PoseGraph.fitFromAfar(guess, relations).poses();
        close(3, 50, new Pose2d(4, -7, 1));
        close(12, 120, new Pose2d(-5, 2, -2));

        PoseGraph.Fit fit = PoseGraph.fit(right, relations);

        assertThat(worst(fit.poses())).isLessThan(worst(right) + 0.1);
        assertThat(PoseGraph.square(
                        relations.getLast(), fit.poses().get(12), fit.poses().get(120)))
                .isGreaterThan(100);
    }

    @Test
    void nothingToFitStaysAsItIs() {
        assertThat(PoseGraph.fit(List.of(Pose2d.ORIGIN), List.of()).poses()).containsExactly(Pose2d.ORIGIN);
        assertThat(PoseGraph.fit(truth, relations.subList(0, 0)).poses()).isEqualTo(truth);
    }

    @Test
    void theSameInputGivesTheSamePoses() {
        close(0, 79, Pose2d.ORIGIN);

        assertThat(PoseGraph.fit(guess, relations).poses())
                .isEqualTo(PoseGraph.fit(guess, relations).poses());
    }

    @Test
    void placesAreKnownTheLessTheFartherTheWay() {
        var uncertainty = new Uncertainty();
        relations.forEach(r -> uncertainty.add(r.from(), r.to(), r.fromFromTo(), r.covariance()));
        double[][] open = uncertainty.from(0, truth.size());
        uncertainty.add(0, 80, new Pose2d(0, 0, 0), LOOP);
        double[][] closed = uncertainty.from(0, truth.size());

        assertThat(open[10][0]).isLessThan(open[40][0]);
        assertThat(open[100][1]).isBetween(0.19, 0.21);
        assertThat(closed[80][0]).isLessThan(0.03);
        assertThat(closed[79][0]).isLessThan(open[79][0]);
        assertThat(closed[40][0]).isEqualTo(open[40][0]);
    }
}
