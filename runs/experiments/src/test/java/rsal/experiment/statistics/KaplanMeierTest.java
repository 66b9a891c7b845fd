package rsal.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class KaplanMeierTest {
    /// Weeks without symptoms: E. Freireich et al., The effect of 6-mercaptopurine, Blood 21(6), 1963, the group that
    /// was treated.
    private static final int[] WEEKS = {6, 6, 6, 6, 7, 9, 10, 10, 11, 13, 16, 17, 19, 20, 22, 23, 25, 32, 32, 34, 35};

    private static final int[] ENDED = {1, 1, 1, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0};

    private static List<Observation> patients() {
        return IntStream.range(0, WEEKS.length)
                .mapToObj(i -> new Observation(WEEKS[i], ENDED[i] == 1))
                .toList();
    }

    /// lifelines 0.30.3 (Python): `KaplanMeierFitter().fit(t, e)`, `survival_function_`, `confidence_interval_`,
    /// `median_survival_time_`, `restricted_mean_survival_time(k, t=30)`.
    @Test
    void isAsLifelinesHasIt() {
        KaplanMeier curve = KaplanMeier.of(patients());
        double[] times = {6, 7, 10, 13, 16, 22, 23};
        double[] shares = {0.857143, 0.806723, 0.752941, 0.690196, 0.627451, 0.537815, 0.448179};
        double[] low = {0.619718, 0.563147, 0.503200, 0.431610, 0.367511, 0.267779, 0.188052};
        double[] high = {0.951552, 0.922809, 0.889362, 0.849066, 0.804912, 0.746791, 0.680143};
        assertThat(curve.steps()).hasSize(times.length);
        for (int i = 0; i < times.length; i++) {
            KaplanMeier.Step step = curve.steps().get(i);
            assertThat(step.time()).isEqualTo(times[i]);
            assertThat(step.share()).isEqualTo(shares[i], within(1e-6));
            assertThat(step.interval().low()).isEqualTo(low[i], within(1e-6));
            assertThat(step.interval().high()).isEqualTo(high[i], within(1e-6));
        }
        assertThat(curve.median()).hasValue(23);
        assertThat(curve.restrictedMean(30)).isEqualTo(21.04649859943977, within(1e-9));
        assertThat(curve.restrictedMean(35)).isEqualTo(23.287394957983185, within(1e-9));
        assertThat(curve.known()).isEqualTo(35);
        assertThat(curve.share(5.9)).isEqualTo(1);
        assertThat(curve.share(30)).isEqualTo(curve.steps().getLast().share());
        assertThat(curve.happened()).isEqualTo(9);
        assertThat(curve.censored()).hasSize(12);
    }

    @Test
    void countsRunsInWhichItCanNeverHappenToTheEnd() {
        KaplanMeier curve = KaplanMeier.of(
                List.of(Observation.happened(10), Observation.never(), Observation.happened(30), Observation.never()));
        assertThat(curve.share(40)).isEqualTo(0.5);
        assertThat(curve.known()).isInfinite();
        assertThat(curve.restrictedMean(100)).isEqualTo((10 + 100 + 30 + 100) / 4.0);
        assertThat(curve.censored()).isEmpty();
    }

    @Test
    void isFlatWhereItNeverHappened() {
        KaplanMeier curve = KaplanMeier.of(List.of(Observation.censored(5), Observation.censored(7)));
        assertThat(curve.steps()).isEmpty();
        assertThat(curve.median()).isEmpty();
        assertThat(curve.restrictedMean(5)).isEqualTo(5);
        assertThatIllegalArgumentException().isThrownBy(() -> KaplanMeier.of(List.of()));
        assertThatIllegalArgumentException().isThrownBy(() -> Observation.happened(Double.POSITIVE_INFINITY));
        assertThatIllegalArgumentException().isThrownBy(() -> Observation.censored(-1));
    }

    /// With nothing censored before the horizon these are the times, cut; else they are as by leaving each run out.
    @Test
    void pseudoTimesAreWhatLeavingARunOutTakesAway() {
        var random = new Random(5);
        for (int trial = 0; trial < 500; trial++) {
            int count = 1 + random.nextInt(12);
            boolean early = random.nextBoolean();
            var runs = new ArrayList<Observation>();
            for (int i = 0; i < count; i++) {
                double time = random.nextInt(20) + (random.nextBoolean() ? 0.5 : 0);
                runs.add(
                        switch (random.nextInt(3)) {
                            case 0 -> early ? Observation.censored(time) : Observation.censored(20);
                            case 1 -> Observation.never();
                            default -> Observation.happened(time);
                        });
            }
            KaplanMeier curve = KaplanMeier.of(runs);
            double horizon = Math.min(curve.known(), 5 + random.nextInt(15));
            double[] pseudo = curve.pseudoTimes(runs, horizon);
            for (int i = 0; i < count; i++) {
                assertThat(pseudo[i])
                        .as("run %d of %s to %s", i, runs, horizon)
                        .isEqualTo(slow(runs, i, horizon), within(1e-9));
                if (!early) {
                    assertThat(pseudo[i]).isEqualTo(Math.min(runs.get(i).time(), horizon), within(1e-9));
                }
            }
            if (!early) {
                assertThat(Arrays.stream(pseudo).average().orElseThrow())
                        .isEqualTo(curve.restrictedMean(horizon), within(1e-9));
            }
        }
    }

    private static double slow(List<Observation> runs, int left, double horizon) {
        if (runs.size() == 1) {
            return KaplanMeier.of(runs).restrictedMean(horizon);
        }
        var others = new ArrayList<>(runs);
        others.remove(left);
        return runs.size() * KaplanMeier.of(runs).restrictedMean(horizon)
                - (runs.size() - 1) * KaplanMeier.of(others).restrictedMean(horizon);
    }
}
