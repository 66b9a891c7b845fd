package rsal.navigation.scanmatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;

class LineMatcherTest {
    private static final double LASER = 0.01; // m; its deviation

    @RepeatedTest(20)
    void findsKnownDisplacements(RepetitionInfo repetition) {
        var random = new SplittableRandom(repetition.getCurrentRepetition());
        Pose2d mapFromA = new Pose2d(random.nextDouble(2, 4), random.nextDouble(2, 4), random.nextDouble(-0.5, 0.5));
        Pose2d aFromB =
                new Pose2d(random.nextDouble(-0.4, 0.4), random.nextDouble(-0.4, 0.4), random.nextDouble(-0.3, 0.3));
        Cloud a = seen(mapFromA, random);
        Cloud b = seen(mapFromA.compose(aFromB), random);
        Pose2d guess = aFromB.compose(
                new Pose2d(random.nextDouble(-0.1, 0.1), random.nextDouble(-0.1, 0.1), random.nextDouble(-0.06, 0.06)));

        Match match = new LineMatcher(a).match(b, guess).orElseThrow();

        assertThat(match.aFromB().isNear(aFromB, 0.02, Math.toRadians(0.4)))
                .as("seed %d: %s, not %s", repetition.getCurrentRepetition(), match.aFromB(), aFromB)
                .isTrue();
        assertThat(match.score()).isGreaterThan(0.7);
    }

    @Test
    void errsAsOftenAsItsCovarianceSays() {
        var random = new SplittableRandom(7);
        Pose2d mapFromA = new Pose2d(3, 3, 0.3);
        double squares = 0;
        int tries = 100;
        for (int i = 0; i < tries; i++) {
            Match match = new LineMatcher(seen(mapFromA, random))
                    .match(seen(mapFromA, random), Pose2d.ORIGIN)
                    .orElseThrow();
            squares +=
                    match.aFromB().x() * match.aFromB().x() / match.covariance().xx();
        }
        assertThat(squares / tries).isBetween(0.05, 2.0); // careful rather than too sure
    }

    @Test
    void isUnsureOfPlacesAlongACorridor() {
        var corridor = new Walls().chain(-100, 0, 100, 0).chain(-100, 2, 100, 2);
        var random = new SplittableRandom(1);
        Cloud a = Cloud.of(corridor.scan(new Pose2d(0, 1, 0), LASER, random), 25);
        Cloud b = Cloud.of(corridor.scan(new Pose2d(0.5, 1.1, 0.02), LASER, random), 25);

        Match match = new LineMatcher(a).match(b, new Pose2d(0.5, 0.05, 0)).orElseThrow();

        assertThat(match.aFromB().y()).isCloseTo(0.1, org.assertj.core.data.Offset.offset(0.02));
        assertThat(Math.sqrt(match.covariance().yy())).isLessThan(0.01);
        assertThat(match.covariance().xx()).isGreaterThan(9 * match.covariance().yy());
    }

    @Test
    void saysNothingWhereThereIsNothingToMatch() {
        Cloud room = seen(new Pose2d(3, 3, 0), new SplittableRandom(1));

        assertThat(new LineMatcher(room).match(Cloud.EMPTY, Pose2d.ORIGIN)).isEmpty();
        assertThat(new LineMatcher(Cloud.EMPTY).match(room, Pose2d.ORIGIN)).isEmpty();
        assertThat(new LineMatcher(room).match(room, new Pose2d(50, 0, 0))).isEmpty();
        assertThat(new LineMatcher(room).match(room, new Pose2d(Double.NaN, 0, 0)))
                .isEmpty();
    }

    @Test
    void matchesWithSeveralScansAtOnce() {
        var random = new SplittableRandom(3);
        Pose2d first = new Pose2d(2, 2, 0);
        Pose2d second = new Pose2d(3, 2, 1);
        Cloud both = Cloud.joined(List.of(
                seen(first, random),
                seen(second, random).movedBy(first.inverse().compose(second))));
        Pose2d third = new Pose2d(3, 3, 2);

        Match match = new LineMatcher(both)
                .match(seen(third, random), first.inverse().compose(third))
                .orElseThrow();

        assertThat(first.compose(match.aFromB()).isNear(third, 0.02, Math.toRadians(0.5)))
                .isTrue();
    }

    private static Cloud seen(Pose2d mapFromBase, SplittableRandom random) {
        return Cloud.of(Walls.room().scan(mapFromBase, LASER, random), 25);
    }
}
