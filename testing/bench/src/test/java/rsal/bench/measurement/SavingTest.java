package rsal.bench.measurement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class SavingTest {
    private static Map<String, Double> saving(double[] ours, double[] theirs) {
        List<Result> results = Saving.of("a", "s", ours, theirs);
        assertThat(Saving.names("a"))
                .containsAll(results.stream().map(Result::name).toList());
        return results.stream().collect(Collectors.toMap(Result::name, Result::value));
    }

    @Test
    void whatDiffersFromTrialToTrialDoesNotMatter() {
        var saving = saving(new double[] {9, 99, 999}, new double[] {12, 102, 1002});
        assertThat(saving).containsEntry("a", 3.0).containsEntry("a.low", 3.0).containsEntry("a.high", 3.0);
        assertThat(saving.get("a.share")).isEqualTo(9.0 / 1116, within(1e-12));
    }

    @Test
    void aFixedShareIsKnownForSure() {
        var saving = saving(new double[] {6, 60, 600}, new double[] {8, 80, 800});
        assertThat(saving.get("a.share")).isEqualTo(0.25, within(1e-12));
        assertThat(saving.get("a.share.low")).isEqualTo(0.25, within(1e-9));
        assertThat(saving.get("a.share.high")).isEqualTo(0.25, within(1e-9));
        assertThat(saving.get("a.high") - saving.get("a.low")).isGreaterThan(100);
    }

    @Test
    void oneTrialSaysNothingOfHowSureItIs() {
        assertThat(saving(new double[] {1}, new double[] {2})).containsOnlyKeys("a", "a.share");
    }

    /// How often the interval of the share holds the true one, when half of it is saved on average.
    @Test
    void theIntervalHoldsTheTrueShareInAboutNineteenOfTwenty() {
        var random = new Random(1);
        int runs = 20_000;
        long held = IntStream.range(0, runs)
                .filter(_ -> {
                    double[] theirs = random.doubles(30, 40, 120).toArray();
                    double[] ours = Arrays.stream(theirs)
                            .map(each -> 0.5 * each + 8 * random.nextGaussian())
                            .toArray();
                    var saving = saving(ours, theirs);
                    return saving.get("a.share.low") <= 0.5 && saving.get("a.share.high") >= 0.5;
                })
                .count();
        assertThat(held / (double) runs).isEqualTo(0.95, within(0.01));
    }
}
