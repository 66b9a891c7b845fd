package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;

class ParticleFilterTest {
    private static final LocalizationMap HALL = new LocalizationMap(Seen.hall(100, 50, -2, 3), 0.1, 0.05);
    private static final LocalizationMap ROOM = new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05);
    private static final Seen SEEN = new Seen(Seen.ROOM);
    private static final Pose2d POSE = new Pose2d(2, 5, 1);

    private static ParticleFilter filter(LocalizationMap map, int least, int most) {
        return new ParticleFilter(map, Amcl.Settings.of(least, most), new SplittableRandom(7));
    }

    private static PoseEstimate belief(Hypothesis... hypotheses) {
        return new PoseEstimate(
                hypotheses[0].mapFromBase(), hypotheses[0].covariance(), List.of(hypotheses), 1, Quality.AMBIGUOUS);
    }

    private static List<Pose2d> poses(ParticleFilter filter) {
        ParticleCloud cloud = filter.cloud();
        var poses = new ArrayList<Pose2d>();
        for (int i = 0; i < cloud.count(); i++) {
            poses.add(new Pose2d(cloud.poses()[3 * i], cloud.poses()[3 * i + 1], cloud.poses()[3 * i + 2]));
        }
        return poses;
    }

    private static void assertEquallyWeighted(ParticleFilter filter) {
        for (float weight : filter.cloud().weights()) {
            assertThat(weight).isCloseTo(1f / filter.count(), within(1e-6f));
        }
    }

    /// Also where x, y and the heading are correlated.
    @Test
    void beginsWithTheDistributionThatItIsGiven() {
        var covariance = new Covariance2d(0.04, 0.018, -0.006, 0.0225, 0.0045, 0.01);
        ParticleFilter filter = filter(HALL, 20_000, 20_000);
        filter.start(PoseEstimate.of(POSE, covariance));
        assertThat(filter.count()).isEqualTo(20_000);
        assertEquallyWeighted(filter);
        Hypothesis found = filter.estimate().hypotheses().getFirst();
        assertThat(found.mapFromBase().isNear(POSE, 0.01, 0.01)).isTrue();
        Covariance2d drawn = found.covariance();
        assertThat(drawn.xx()).isCloseTo(0.04, within(0.002));
        assertThat(drawn.xy()).isCloseTo(0.018, within(0.001));
        assertThat(drawn.xTheta()).isCloseTo(-0.006, within(0.0006));
        assertThat(drawn.yy()).isCloseTo(0.0225, within(0.001));
        assertThat(drawn.yTheta()).isCloseTo(0.0045, within(0.0005));
        assertThat(drawn.thetaTheta()).isCloseTo(0.01, within(0.0005));
    }

    @Test
    void aPoseThatIsKnownExactlyIsThatOfAllParticles() {
        ParticleFilter filter = filter(HALL, 50, 5000);
        filter.start(PoseEstimate.of(POSE, Covariance2d.ofDeviations(0, 0, 0)));
        assertThat(filter.count())
                .as("one bin asks for no more than there are at least")
                .isEqualTo(50);
        assertThat(poses(filter)).allMatch(pose -> pose.isNear(POSE, 1e-6, 1e-6));
    }

    @Test
    void hypothesesGetParticlesByTheirWeights() {
        var narrow = Covariance2d.ofDeviations(0.05, 0.05, 0.05);
        ParticleFilter filter = filter(HALL, 10_000, 10_000);
        filter.start(belief(
                new Hypothesis(0.45, POSE, narrow),
                new Hypothesis(0.3, new Pose2d(5, 5, 1), narrow),
                new Hypothesis(0.15, new Pose2d(2, 7, -2), narrow))); // 0.9 in all
        List<Hypothesis> found = filter.estimate().hypotheses();
        assertThat(found).hasSize(3);
        assertThat(found.get(0).weight()).isCloseTo(3 / 6.0, within(0.02));
        assertThat(found.get(1).weight()).isCloseTo(2 / 6.0, within(0.02));
        assertThat(found.get(2).weight()).isCloseTo(1 / 6.0, within(0.02));
    }

    @Test
    void aWideBeliefHasMoreParticlesAndNeverTooMany() {
        ParticleFilter narrow = filter(HALL, 10, 100_000);
        narrow.start(PoseEstimate.of(POSE, Covariance2d.ofDeviations(0.2, 0.2, 0.1)));
        ParticleFilter wide = filter(HALL, 10, 100_000);
        wide.start(PoseEstimate.of(POSE, Covariance2d.ofDeviations(1, 1, 0.5)));
        assertThat(narrow.count()).isBetween(50, 1000);
        assertThat(wide.count()).isGreaterThan(3 * narrow.count());
        ParticleFilter bounded = filter(HALL, 10, 300);
        bounded.start(PoseEstimate.of(POSE, Covariance2d.ofDeviations(1, 1, 0.5)));
        assertThat(bounded.count()).isEqualTo(300);
    }

    /// A tenth of them; the rest is shared out evenly.
    @Test
    void isScatteredAroundCandidatesAndAFewAnywhere() {
        List<Pose2d> candidates = List.of(POSE, new Pose2d(6, 6, -1), new Pose2d(0, 4, 3));
        ParticleFilter filter = filter(HALL, 10, 3000);
        filter.scatter(candidates);
        assertThat(filter.count()).isEqualTo(3000);
        assertEquallyWeighted(filter);
        List<Pose2d> poses = poses(filter);
        for (int candidate = 0; candidate < 3; candidate++) {
            Pose2d around = candidates.get(candidate);
            int first = candidate;
            List<Pose2d> near = IntStream.range(0, 900)
                    .mapToObj(i -> poses.get(3 * i + first))
                    .toList();
            assertThat(near).allMatch(pose -> pose.isNear(around, 0.6, 0.3));
            assertThat(near.stream()
                            .mapToDouble(pose -> Math.pow(pose.x() - around.x(), 2))
                            .average()
                            .orElseThrow())
                    .isCloseTo(Math.pow(AlternativeHypotheses.DEVIATION, 2), within(0.002));
        }
        assertAnywhere(poses.subList(2700, 3000));
    }

    @Test
    void isScatteredOverTheWholeFloorWhereNothingIsKnown() {
        ParticleFilter filter = filter(HALL, 10, 2000);
        filter.scatter(List.of());
        assertThat(filter.count()).isEqualTo(2000);
        assertAnywhere(poses(filter));
    }

    /// In quarters of the floor, from -2 to 8 m and from 3 to 8 m, and of headings.
    private static void assertAnywhere(List<Pose2d> poses) {
        OccupancyGrid grid = HALL.grid;
        assertThat(poses).allMatch(pose -> grid.isFree(pose.x(), pose.y()));
        int least = poses.size() / 6;
        assertThat(poses.stream().filter(pose -> pose.x() < 3 && pose.y() < 5.5))
                .hasSizeGreaterThan(least);
        assertThat(poses.stream().filter(pose -> pose.x() > 3 && pose.y() < 5.5))
                .hasSizeGreaterThan(least);
        assertThat(poses.stream().filter(pose -> pose.x() < 3 && pose.y() > 5.5))
                .hasSizeGreaterThan(least);
        assertThat(poses.stream().filter(pose -> pose.x() > 3 && pose.y() > 5.5))
                .hasSizeGreaterThan(least);
        for (int quarter = -2; quarter < 2; quarter++) {
            double from = quarter * Math.PI / 2;
            assertThat(poses.stream().filter(pose -> pose.theta() > from && pose.theta() < from + Math.PI / 2))
                    .hasSizeGreaterThan(least);
        }
    }

    @Test
    void aMapWithoutFreeFloorDoesNotHangIt() {
        var full = new OccupancyGrid(2, 2, 0.5, 0, 0, new byte[] {
            OccupancyGrid.OCCUPIED, OccupancyGrid.OCCUPIED, OccupancyGrid.OCCUPIED, OccupancyGrid.OCCUPIED
        });
        ParticleFilter filter = filter(new LocalizationMap(full, 0.1, 0.05), 10, 20);
        filter.scatter(List.of());
        assertThat(filter.count()).isEqualTo(20);
    }

    /// By the likelihood of the scan, where 15 beams count as independent.
    @Test
    void weighsParticlesByWhatIsSeen() {
        Pose2d truth = Seen.ROOM.pose('a', 0);
        Beams beams = SEEN.beams(truth, 60);
        ParticleFilter filter = filter(ROOM, 200, 200);
        filter.start(PoseEstimate.of(truth, Covariance2d.ofDeviations(0.1, 0.1, 0.05)));
        ParticleCloud before = filter.cloud();
        filter.weigh(beams, 1);
        ParticleCloud after = filter.cloud();
        double share = Math.min(1, 15.0 / beams.count());
        double[] expected = IntStream.range(0, 200)
                .mapToDouble(i -> Math.exp(share
                        * ROOM.walls.log(
                                beams, before.poses()[3 * i], before.poses()[3 * i + 1], before.poses()[3 * i + 2])))
                .toArray();
        double sum = IntStream.range(0, 200).mapToDouble(i -> expected[i]).sum();
        for (int i = 0; i < 200; i++) {
            assertThat((double) after.weights()[i])
                    .isCloseTo(expected[i] / sum, within(1e-3 * expected[i] / sum + 1e-6));
        }
        filter.weigh(beams, 1); // once more: the square
        ParticleCloud twice = filter.cloud();
        double squares = IntStream.range(0, 200)
                .mapToDouble(i -> expected[i] * expected[i])
                .sum();
        for (int i = 0; i < 200; i++) {
            double square = expected[i] * expected[i] / squares;
            assertThat((double) twice.weights()[i]).isCloseTo(square, within(2e-3 * square + 1e-6));
        }
    }

    /// Each particle is drawn as often as its weight says, but for less than one (low variance sampling).
    @Test
    void unevenParticlesAreDrawnAgain() {
        Pose2d truth = Seen.ROOM.pose('a', 0);
        ParticleFilter filter = filter(ROOM, 200, 200);
        filter.start(PoseEstimate.of(truth, Covariance2d.ofDeviations(0.3, 0.3, 0.2)));
        filter.resampleIfDue();
        List<Pose2d> before = poses(filter);
        filter.resampleIfDue();
        assertThat(poses(filter)).as("even ones stay as they are").isEqualTo(before);
        filter.weigh(SEEN.beams(truth, 60), 1);
        float[] weights = filter.cloud().weights();
        filter.resampleIfDue();
        List<Pose2d> after = poses(filter);
        assertThat(after).hasSize(200).isNotEqualTo(before);
        assertEquallyWeighted(filter);
        for (int i = 0; i < 200; i++) {
            Pose2d pose = before.get(i);
            assertThat((double) after.stream().filter(pose::equals).count())
                    .as("particle %d of weight %s", i, weights[i])
                    .isCloseTo(200 * weights[i], within(1.001));
        }
    }

    @Test
    void injectsAFifthNearAPoseInPlaceOfOthers() {
        ParticleFilter filter = filter(HALL, 1000, 1000);
        filter.start(PoseEstimate.of(POSE, Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        var there = new Pose2d(6, 6, -2);
        filter.inject(there);
        assertThat(filter.count()).isEqualTo(1000);
        assertEquallyWeighted(filter);
        assertThat(poses(filter).stream().filter(pose -> pose.isNear(there, 0.6, 0.3)))
                .hasSize(200);
    }
}
