package rsal.navigation.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;

class VerdictTest {
    @Test
    void countsFromTheScanWhereItIsNearAndStays() {
        Verdict verdict = Verdict.of(steps(9, 0.1, 9, 0.3, 0.4, 0.3, 0.4, 0.3, 0.4));

        assertThat(verdict.converged()).hasValue(4);
        assertThat(verdict.judged()).isEqualTo(9);
        assertThat(verdict.rmse()).isCloseTo(Math.sqrt((0.09 + 0.16) / 2), within(1e-9));
        assertThat(verdict.p95()).isCloseTo(0.4, within(1e-9));
        assertThat(verdict.near()).isEqualTo(1);
        assertThat(verdict.falselySure()).isEqualTo(2);
    }

    @Test
    void whatGoesWrongLaterCounts() {
        Verdict verdict = Verdict.of(steps(0, 0, 0, 0, 0, 3, 3, 3, 3, 3));

        assertThat(verdict.converged()).hasValue(1);
        assertThat(verdict.near()).isEqualTo(0.5);
        assertThat(verdict.worst()).isCloseTo(3, within(1e-9));
    }

    @Test
    void neverConvergedIsSaidSo() {
        Verdict verdict = Verdict.of(steps(3, 3, 0.1, 3));

        assertThat(verdict.converged()).isEmpty();
        assertThat(verdict.rmse()).isNaN();
        assertThat(Verdict.of(List.of()).converged()).isEmpty();
    }

    @Test
    void oneScanThatIsNearAtTheVeryEndIsNotConverged() {
        assertThat(Verdict.of(steps(3, 3, 3, 3, 3, 3, 3, 0.1)).converged()).isEmpty();
        assertThat(Verdict.of(steps(0.1, 0.1, 0.1)).converged()).hasValue(1);
    }

    @Test
    void whoPassesTheRightPlaceWithoutKnowingHasNotConverged() {
        assertThat(Verdict.of(steps(Quality.AMBIGUOUS, 3, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 3))
                        .converged())
                .isEmpty();

        List<Replay.Step> known = new ArrayList<>(steps(Quality.AMBIGUOUS, 0.1, 0.1, 0.1, 0.1, 0.1, 3, 0.1, 0.1, 0.1));
        known.addAll(steps(0.1, 0.1, 0.1, 0.1));
        assertThat(Verdict.of(known).converged()).hasValue(7);
    }

    @Test
    void runsAreSummedUpByAllTheirScansAndTheWorstBesideThem() {
        Verdict good = Verdict.of(steps(9, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1));
        Verdict bad = Verdict.of(steps(0, 0, 0, 0, 0, 0, 0, 0, 0, 3));
        Verdict never = Verdict.of(steps(9, 9, 9, 9, 9, 9, 9));

        Verdict.Pooled pooled = Verdict.pooled(List.of(good, never, bad, good));

        assertThat(pooled.rmse()).isCloseTo(Math.sqrt((18 * 0.01 + 9) / 28), within(1e-9));
        assertThat(pooled.worstRmse()).isCloseTo(Math.sqrt(9 / 10.0), within(1e-9));
        assertThat(pooled.p95()).isCloseTo(0.1, within(1e-9));
        assertThat(Verdict.pooled(List.of(never)).rmse()).isNaN();
        assertThat(Verdict.pooled(List.of(never)).worstRmse()).isNaN();
        assertThat(Verdict.pooled(List.of(never)).p95()).isNaN();
    }

    private static List<Replay.Step> steps(double... errors) {
        return steps(Quality.LOCALIZED, errors);
    }

    private static List<Replay.Step> steps(Quality quality, double... errors) {
        var scan = new LaserScan(Pose2d.ORIGIN, 0, 0, 0, 1, new float[] {1});
        return Arrays.stream(errors)
                .mapToObj(error -> new Replay.Step(
                        new RecordedDrive.Stop(1, Instant.EPOCH, scan, Pose2d.ORIGIN, Optional.of(Pose2d.ORIGIN)),
                        new PoseEstimate(
                                new Pose2d(error, 0, 0),
                                Covariance2d.ofDeviations(0.1, 0.1, 0.1),
                                List.of(),
                                1,
                                quality),
                        1,
                        0,
                        true))
                .toList();
    }
}
