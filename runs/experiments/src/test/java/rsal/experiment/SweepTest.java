package rsal.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.settings.InvalidSettings;

class SweepTest {
    @TempDir
    Path folder;

    @Test
    void combinesEverythingSeedBySeed() {
        Sweep sweep = Sweep.of(Guards.in(folder), Guards.design(2));
        assertThat(sweep.trials())
                .extracting(t -> t.number() + ": " + t.combination() + ", seed " + t.seed())
                .containsExactly(
                        "1: long, guards=1, seed 1",
                        "2: long, guards=2, seed 1",
                        "3: short, guards=1, seed 1",
                        "4: short, guards=2, seed 1",
                        "5: long, guards=1, seed 2",
                        "6: long, guards=2, seed 2",
                        "7: short, guards=1, seed 2",
                        "8: short, guards=2, seed 2");
        assertThat(sweep.valueNames()).containsExactly("guards", "way.guard-1", "firstCollision", "way.guard-2");
    }

    @Test
    void reportsEveryErrorOfEveryCombinationBeforeAnythingStarts() {
        var design =
                new Design(List.of("long", "shrt"), List.of(), Map.of("guards", "9"), List.of(1L), Optional.empty());
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Sweep.of(Guards.in(folder), design))
                .withMessageContainingAll("--set guards=9", "from 1 to 4", "'shrt'", "Maybe 'short'");
    }

    @Test
    void refusesRunsThatCantBeComparedOrNeverEnd() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(
                        () -> Sweep.of(Guards.in(folder), Guards.with(List.of("real", "endless"), Optional.empty())))
                .withMessageContainingAll("'real' runs in real time", "'endless' has no end of its own", "--for");
        assertThat(Sweep.of(Guards.in(folder), Guards.with(List.of("endless"), Optional.of(Duration.ofSeconds(1))))
                        .trials())
                .hasSize(1);
    }

    @Test
    void refusesWhatIsSaidTwice() {
        var both = new Design(
                List.of("long"),
                List.of(new Factor("guards", List.of("1"))),
                Map.of("guards", "2"),
                List.of(1L),
                Optional.empty());
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Sweep.of(Guards.in(folder), both))
                .withMessageContaining("'guards' is varied, too");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Sweep.of(Guards.in(folder), Guards.with(List.of("long", "long"), Optional.empty())))
                .withMessageContaining("'long' is there twice");
    }

    @Test
    void refusesMoreRunsThanAnybodyCanWaitFor() {
        List<String> many =
                LongStream.rangeClosed(1, 5000).mapToObj(Long::toString).toList();
        var design = new Design(
                List.of("long"),
                List.of(new Factor("a", many), new Factor("b", many), new Factor("c", many), new Factor("d", many)),
                Map.of(),
                List.of(1L),
                Optional.empty());
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Sweep.of(Guards.in(folder), design))
                .withMessageContaining("more than 1000000 runs");
    }
}
