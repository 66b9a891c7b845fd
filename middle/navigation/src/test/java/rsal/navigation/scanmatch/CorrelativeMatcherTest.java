package rsal.navigation.scanmatch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.CorrelativeMatcher.Settings;
import rsal.navigation.scanmatch.CorrelativeMatcher.Spot;
import rsal.navigation.scanmatch.CorrelativeMatcher.Window;

class CorrelativeMatcherTest {
    @RepeatedTest(10)
    void findsDisplacementsFarFromTheGuess(RepetitionInfo repetition) {
        var random = new SplittableRandom(repetition.getCurrentRepetition());
        Pose2d mapFromA = new Pose2d(random.nextDouble(2, 4), random.nextDouble(2, 4), random.nextDouble(-0.5, 0.5));
        Pose2d aFromB =
                new Pose2d(random.nextDouble(-0.5, 0.5), random.nextDouble(-0.5, 0.5), random.nextDouble(-0.4, 0.4));
        Pose2d guess = aFromB.compose(
                new Pose2d(random.nextDouble(-1.5, 1.5), random.nextDouble(-1.5, 1.5), random.nextDouble(-0.4, 0.4)));

        Match match = new CorrelativeMatcher(seen(mapFromA, random), Settings.DEFAULT)
                .match(seen(mapFromA.compose(aFromB), random), guess, new Window(2.2, 0.5), 0.4)
                .orElseThrow();

        assertThat(match.aFromB().isNear(aFromB, 0.1, Math.toRadians(1.5)))
                .as("seed %d: %s, not %s", repetition.getCurrentRepetition(), match.aFromB(), aFromB)
                .isTrue();
    }

    @RepeatedTest(10)
    void missesNoBetterPlaceThanTryingAll(RepetitionInfo repetition) {
        var random = new SplittableRandom(repetition.getCurrentRepetition());
        Cloud a = seen(new Pose2d(3, 3, random.nextDouble(-3, 3)), random);
        Cloud b = seen(new Pose2d(4, 2.5, random.nextDouble(-3, 3)), random);
        Window window = new Window(0.8, 0.1, random.nextInt(2) * 0.3);
        Pose2d guess = new Pose2d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-3, 3));

        Match bounded = new CorrelativeMatcher(a, new Settings(0.1, 0.1, 5))
                .match(b, guess, window, 0)
                .orElseThrow();
        Match all = new CorrelativeMatcher(a, new Settings(0.1, 0.1, 0))
                .match(b, guess, window, 0)
                .orElseThrow();

        assertThat(bounded.score())
                .as("seed %d", repetition.getCurrentRepetition())
                .isCloseTo(all.score(), Offset.offset(1e-9));
    }

    @Test
    void missesNoHeadingHoweverFarPointsAre() {
        var posts = new Walls();
        for (int i = 0; i < 24; i++) {
            double bearing = 0.4 * i - 0.002 * i * i; // each a gap of its own
            double x = 28 * Math.cos(bearing);
            double y = 28 * Math.sin(bearing);
            posts.box(x - 0.3, y - 0.3, x + 0.3, y + 0.3);
        }
        var random = new SplittableRandom(1);
        Cloud a = Cloud.of(posts.scan(Pose2d.ORIGIN, 0, random), 30);
        double finest = 0.05 / 28;
        var matcher = new CorrelativeMatcher(a, new Settings(0.05, 0.04, 2));
        for (int i = 0; i < 5; i++) {
            double theta = (500.3 + i * 7.25) * finest; // of 2 rad
            Cloud turned = a.movedBy(new Pose2d(0, 0, -theta));

            Match match = matcher.match(turned, Pose2d.ORIGIN, new Window(0.1, 2), 0.1)
                    .orElseThrow();

            assertThat(match.aFromB().theta()).isCloseTo(theta, Offset.offset(finest));
            assertThat(match.score()).as("%s", theta).isGreaterThan(0.75);
        }
    }

    @Test
    void findsTheRivalOfAPlace() {
        var random = new SplittableRandom(1);
        var twice = new Walls().box(0, 0, 6, 4).box(1, 1, 1.4, 1.4).box(4.6, 2.6, 5, 3);
        Cloud whole = Cloud.joined(List.of(
                Cloud.of(twice.scan(new Pose2d(3, 1, Math.PI / 2), 0, random), 25)
                        .movedBy(new Pose2d(3, 1, Math.PI / 2)),
                Cloud.of(twice.scan(new Pose2d(3, 3, -Math.PI / 2), 0, random), 25)
                        .movedBy(new Pose2d(3, 3, -Math.PI / 2))));
        Cloud here = Cloud.of(twice.scan(new Pose2d(2.5, 2, 0.3), 0, random), 25);
        var matcher = new CorrelativeMatcher(whole, new Settings(0.1, 0.1, 4));
        var window = new Window(4, Math.PI);

        Match best = matcher.match(here, new Pose2d(3, 2, 0), window, 0.3).orElseThrow();
        Match rival = matcher.matchElsewhere(here, new Pose2d(3, 2, 0), window, 0.3, new Spot(best.aFromB(), 1, 0.3))
                .orElseThrow();

        List<Pose2d> both = List.of(best.aFromB(), rival.aFromB());
        assertThat(both).anyMatch(pose -> pose.isNear(new Pose2d(2.5, 2, 0.3), 0.2, 0.05));
        assertThat(both).anyMatch(pose -> pose.isNear(new Pose2d(3.5, 2, 0.3 - Math.PI), 0.2, 0.05));
        assertThat(rival.score()).isLessThanOrEqualTo(best.score());
    }

    @Test
    void isUnsureAlongACorridor() {
        var corridor = new Walls().chain(-100, 0, 100, 0).chain(-100, 2, 100, 2);
        var random = new SplittableRandom(1);
        Cloud a = Cloud.of(corridor.scan(new Pose2d(0, 1, 0), 0.01, random), 25);

        Match match = new CorrelativeMatcher(a, Settings.DEFAULT)
                .match(a, Pose2d.ORIGIN, new Window(0.5, 0.1), 0)
                .orElseThrow();

        assertThat(match.covariance().xx()).isGreaterThan(2 * match.covariance().yy());
    }

    @Test
    void prefersTheGuessWhereOthersFitAsWell() {
        var corridor = new Walls().chain(-100, 0, 100, 0).chain(-100, 2, 100, 2);
        var random = new SplittableRandom(1);
        Cloud a = Cloud.of(corridor.scan(new Pose2d(0, 1, 0), 0, random), 10);

        Match match = new CorrelativeMatcher(a, Settings.DEFAULT)
                .match(a, new Pose2d(0.3, 0, 0), new Window(0.5, 0.1, 3), 0)
                .orElseThrow();

        assertThat(match.aFromB().x()).isBetween(0.1, 0.35);
    }

    @Test
    void refusesWhatFitsTooBadlyOrIsNothing() {
        Cloud room = seen(new Pose2d(3, 3, 0), new SplittableRandom(1));
        var matcher = new CorrelativeMatcher(room, Settings.DEFAULT);

        assertThat(matcher.match(room, new Pose2d(40, 0, 0), new Window(1, 1), 0.2))
                .isEmpty();
        assertThat(matcher.match(Cloud.EMPTY, Pose2d.ORIGIN, new Window(1, 1), 0))
                .isEmpty();
        assertThat(matcher.match(room, new Pose2d(Double.NaN, 0, 0), new Window(1, 1), 0))
                .isEmpty();
        assertThat(new CorrelativeMatcher(Cloud.EMPTY, Settings.DEFAULT)
                        .match(room, Pose2d.ORIGIN, new Window(1, 1), 0.1))
                .isEmpty();
        assertThatThrownBy(() -> new Window(-1, 0)).hasMessageContaining("-1");
        assertThatThrownBy(() -> new Settings(0, 1, 1)).hasMessageContaining("Resolution");
    }

    private static Cloud seen(Pose2d mapFromBase, SplittableRandom random) {
        return Cloud.of(Walls.room().scan(mapFromBase, 0.01, random), 25);
    }
}
