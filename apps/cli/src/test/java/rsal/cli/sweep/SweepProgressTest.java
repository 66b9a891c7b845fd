package rsal.cli.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class SweepProgressTest {
    @Test
    void theTimeLeftIsThatOfTheRunsOfThisSession() {
        assertThat(SweepProgress.line(0, 0, 40, 0, Duration.ofSeconds(1))).isEqualTo("0/40");
        assertThat(SweepProgress.line(10, 0, 40, 1, Duration.ofSeconds(50)))
                .isEqualTo("10/40, 1 broken, 2 min 30 s left");
        assertThat(SweepProgress.line(30, 20, 40, 0, Duration.ofSeconds(50))).isEqualTo("30/40, 50 s left");
        assertThat(SweepProgress.line(30, 30, 40, 0, Duration.ZERO)).isEqualTo("30/40");
        assertThat(SweepProgress.line(1, 0, 1000, 0, Duration.ofSeconds(10))).endsWith("2 h 46 min left");
        assertThat(SweepProgress.line(40, 0, 40, 0, Duration.ofSeconds(50))).isEqualTo("40/40");
    }

    @Test
    void theBarFillsUp() {
        assertThat(SweepProgress.bar(0, 40)).doesNotContain("━").hasSize(30);
        assertThat(SweepProgress.bar(20, 40)).isEqualTo("━".repeat(15) + "┄".repeat(15));
        assertThat(SweepProgress.bar(40, 40)).doesNotContain("┄");
    }
}
