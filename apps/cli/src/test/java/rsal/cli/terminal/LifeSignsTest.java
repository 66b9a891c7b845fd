package rsal.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class LifeSignsTest {
    @Test
    void areGivenEverMoreSeldom() {
        var signs = new LifeSigns();
        assertThat(IntStream.range(0, 100).filter(second -> signs.isDue(TimeUnit.SECONDS.toNanos(second))))
                .containsExactly(10, 20, 40, 80);
    }

    @Test
    void areGivenOnceWhereNobodyAskedForLong() {
        var signs = new LifeSigns();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(100))).isTrue();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(101))).isFalse();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(160))).isTrue();
    }

    @Test
    void saysOnceThatSomethingStandsStill() {
        var signs = new LifeSigns();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(10), true)).isTrue();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(20), true)).isFalse();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(40), false)).isTrue();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(80), true)).isTrue();
        assertThat(signs.isDue(TimeUnit.SECONDS.toNanos(160), true)).isFalse();
    }
}
