package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate.Hypothesis;

class AlternativeHypothesesTest {
    private static final double BEAMS = 10; // independent ones
    private static final Covariance2d WIDE = Covariance2d.ofDeviations(0.5, 0.5, 0.3);
    private static final Covariance2d NARROW = Covariance2d.ofDeviations(0.02, 0.02, 0.02);

    private final LocalizationMap map = new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05);
    private final GlobalSearch search = new GlobalSearch(map);
    private final AlternativeHypotheses held =
            new AlternativeHypotheses(search, new Refinement(map.toFace, 0.1, BEAMS), BEAMS);

    private static Hypothesis cluster(double weight, double x) {
        return new Hypothesis(weight, new Pose2d(x, 0, 0), NARROW);
    }

    private double shareAt(double x) {
        return held.share(new Pose2d(x, 0, 0), 0.5, 0.3);
    }

    @ParameterizedTest
    @CsvSource({"0.24, 0, 0, 1", "0.26, 0, 0, 2", "0, 0.26, 0, 2", "0, 0, 0.14, 1", "0, 0, -0.16, 2"})
    void aPlaceThatIsNearAnotherOneIsTheSame(double x, double y, double theta, int count) {
        held.add(Pose2d.ORIGIN, 0);
        held.add(new Pose2d(x, y, theta), 0);
        assertThat(held.count()).isEqualTo(count);
    }

    @Test
    void whenAllAreTakenTheLeastLikelyMakesRoom() {
        for (int i = 0; i < AlternativeHypotheses.MOST; i++) {
            held.add(new Pose2d(i, 0, 0), i == 70 ? -5 : -1);
        }
        held.add(new Pose2d(-1, 0, 0), -2);
        assertThat(held.count()).isEqualTo(AlternativeHypotheses.MOST);
        assertThat(held.hasNear(new Pose2d(70, 0, 0), 0.1, 0.1)).isFalse();
        assertThat(held.hasNear(new Pose2d(-1, 0, 0), 0.1, 0.1)).isTrue();
        held.clear();
        assertThat(held.count()).isZero();
        assertThat(held.hasNear(new Pose2d(-1, 0, 0), 0.1, 0.1)).isFalse();
    }

    @Test
    void theBestIsTheLikeliest() {
        held.add(new Pose2d(1, 0, 0), -1);
        held.add(new Pose2d(2, 0, 0), 0);
        held.add(new Pose2d(3, 0, 0), -2);
        assertThat(held.best()).isEqualTo(new Pose2d(2, 0, 0));
    }

    @Test
    void sharesAreLikelihoodsOverTheirSum() {
        held.add(new Pose2d(0, 0, 0), 0);
        held.add(new Pose2d(5, 0, 0), -1);
        held.add(new Pose2d(5.3, 0, 0), -2);
        double sum = 1 + Math.exp(-1) + Math.exp(-2);
        assertThat(shareAt(0)).isCloseTo(1 / sum, within(1e-12));
        assertThat(shareAt(5.2)).isCloseTo((Math.exp(-1) + Math.exp(-2)) / sum, within(1e-12));
        assertThat(shareAt(9)).isZero();
    }

    @Test
    void nothingHasAShareWhenThereIsNone() {
        assertThat(shareAt(0)).isZero();
    }

    @Test
    void theyMoveAsTheBaseDoesWhileNothingIsSeen() {
        held.add(new Pose2d(1, 2, Math.PI / 2), 0);
        held.follow(new Pose2d(0.5, 0, 0.1), NARROW, Seen.NOTHING);
        assertThat(held.best().isNear(new Pose2d(1, 2.5, Math.PI / 2 + 0.1), 1e-9, 1e-9))
                .isTrue();
    }

    @Test
    void scansMendThemByWhatIsAround() {
        Pose2d truth = Seen.ROOM.pose('a', 30);
        held.add(truth.compose(new Pose2d(-0.35, 0.05, -0.05)), 0);
        held.follow(new Pose2d(0.3, 0, 0), WIDE, new Seen(Seen.ROOM).beams(truth, 60));
        assertThat(held.best().isNear(truth, 0.04, 0.03)).isTrue();
    }

    /// What fits worse than the best by less than 0.15 for each beam is as likely as before.
    @Test
    void aPlaceLosesWhatItFitsWorseByForEachIndependentBeam() {
        Pose2d truth = Seen.ROOM.pose('a', 30);
        Pose2d wrong = Seen.ROOM.pose('b', 100);
        Beams beams = new Seen(Seen.ROOM).beams(truth, 60);
        held.add(truth, 0);
        held.add(wrong, 0);
        var refinement = new Refinement(map.toFace, 0.1, BEAMS);
        double fit = search.score(beams, refinement.refine(beams, truth, NARROW));
        double wrongFit = search.score(beams, refinement.refine(beams, wrong, NARROW));
        double loss = BEAMS * (fit - wrongFit - 0.15);
        held.follow(Pose2d.ORIGIN, NARROW, beams);
        if (loss > 12) {
            assertThat(held.count()).isEqualTo(1);
        } else {
            assertThat(held.share(wrong, 0.5, 0.5)).isCloseTo(1 / (1 + Math.exp(loss)), within(1e-9));
        }
        assertThat(loss).isPositive();
    }

    @ParameterizedTest
    @CsvSource({"-11.9, 2", "-12.1, 1"})
    void whatIsFarLessLikelyIsDropped(double log, int count) {
        Pose2d truth = Seen.ROOM.pose('a', 30);
        held.add(truth, 0);
        held.add(truth.compose(new Pose2d(0, 0, 0.2)), log); // as far as the scan is empty of walls, as good
        held.follow(Pose2d.ORIGIN, NARROW, farAway());
        assertThat(held.count()).isEqualTo(count);
    }

    @Test
    void logsAreThoseToTheLikeliest() {
        held.add(Pose2d.ORIGIN, -3);
        held.add(new Pose2d(5, 0, 0), -4);
        held.follow(Pose2d.ORIGIN, NARROW, farAway());
        held.add(new Pose2d(9, 0, 0), 0); // as likely as the best now
        double sum = 2 + Math.exp(-1);
        assertThat(shareAt(0)).isCloseTo(1 / sum, within(1e-9));
        assertThat(shareAt(9)).isCloseTo(1 / sum, within(1e-9));
    }

    /// Two that come to the same place are one, as likely as the likelier of them.
    @Test
    void placesThatMeetAreOne() {
        Pose2d truth = Seen.ROOM.pose('a', 30);
        held.add(truth.compose(new Pose2d(-0.2, 0, 0)), -2);
        held.add(truth.compose(new Pose2d(0.2, 0, 0)), 0);
        held.add(Seen.ROOM.pose('b', 0), -1);
        held.follow(Pose2d.ORIGIN, WIDE, new Seen(Seen.ROOM).beams(truth, 60));
        assertThat(held.share(truth, 0.1, 0.1)).isGreaterThan(0.5);
        assertThat(held.hasNear(truth, 0.05, 0.05)).isTrue();
        held.add(truth, 0);
        assertThat(held.count()).isLessThanOrEqualTo(2);
    }

    /// Beams that end far from all of the map fit everywhere alike, and move nothing.
    private static Beams farAway() {
        return Seen.straight(1e3f, 1e3f, 1e3f);
    }

    @Test
    void withoutThemClustersStayAsTheyAre() {
        List<Hypothesis> clusters = List.of(cluster(0.7, 0), cluster(0.3, 5));
        assertThat(held.join(clusters, 0.5, 0.3)).isSameAs(clusters);
    }

    @Test
    void theFirstClusterIsNoHeavierThanItsPlacesAre() {
        held.add(new Pose2d(0, 0, 0), 0);
        held.add(new Pose2d(5, 0, 0), 0);
        held.add(new Pose2d(9, 0, 0), 0);
        List<Hypothesis> joined = held.join(List.of(cluster(0.9, 0), cluster(0.1, 5)), 0.5, 0.3);
        assertThat(joined).extracting(h -> h.mapFromBase().x()).containsExactly(0.0, 5.0, 9.0);
        assertThat(joined).allSatisfy(h -> assertThat(h.weight()).isCloseTo(1.0 / 3, within(1e-9)));
    }

    @Test
    void noneIsHeavierThanTheFirst() {
        held.add(new Pose2d(0, 0, 0), -3);
        held.add(new Pose2d(5, 0, 0), 0);
        double first = Math.exp(-3) / (1 + Math.exp(-3));
        List<Hypothesis> joined = held.join(List.of(cluster(0.9, 0)), 0.5, 0.3);
        assertThat(joined).hasSize(2);
        assertThat(joined.getFirst().weight()).isCloseTo(first, within(1e-9));
        assertThat(joined.get(1).weight()).isCloseTo(first, within(1e-9));
    }

    @Test
    void togetherTheyWeighOneAtMost() {
        held.add(new Pose2d(0, 0, 0), 0);
        held.add(new Pose2d(5, 0, 0), -1);
        List<Hypothesis> joined = held.join(List.of(cluster(0.5, 0), cluster(0.3, 5), cluster(0.2, 9)), 0.5, 0.3);
        double second = Math.max(0.3, Math.exp(-1) / (1 + Math.exp(-1)));
        double scale = Math.min(1, 0.5 / (second + 0.2));
        assertThat(joined).extracting(h -> h.mapFromBase().x()).containsExactly(0.0, 5.0, 9.0);
        assertThat(joined.get(0).weight()).isCloseTo(0.5, within(1e-9));
        assertThat(joined.get(1).weight()).isCloseTo(scale * second, within(1e-9));
        assertThat(joined.get(2).weight()).isCloseTo(scale * 0.2, within(1e-9));
    }

    @Test
    void aPlaceWithoutParticlesIsReportedWithItsUncertainty() {
        held.add(new Pose2d(5, 0, 0), 0);
        held.add(new Pose2d(0, 0, 0), 0);
        Hypothesis other = held.join(List.of(cluster(1, 0)), 0.5, 0.3).get(1);
        assertThat(other.covariance()).isEqualTo(Covariance2d.ofDeviations(0.1, 0.1, 0.05));
    }

    @Test
    void tenAreReportedTheHeaviestFirst() {
        held.add(new Pose2d(0, 0, 0), 0);
        for (int i = 1; i <= 14; i++) {
            held.add(new Pose2d(i, 0, 0), -0.1 * (15 - i));
        }
        List<Hypothesis> joined = held.join(List.of(cluster(1, 0)), 0.4, 0.3);
        assertThat(joined).hasSize(10);
        assertThat(joined).extracting(h -> h.mapFromBase().x()).startsWith(0.0, 14.0, 13.0, 12.0);
    }
}
