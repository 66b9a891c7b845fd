package rsal.testkit.architecture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Instant;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import rsal.time.AllowedToReadWallClock;

/// The rules find what they forbid: the classes below break each of them.
class ArchitectureRulesTest {
    private final ArchitectureRules rules = new Rules();

    @Test
    void findReadingTheClock() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::timeIsHandedIn)
                .withMessageContaining("Offender.instant")
                .withMessageContaining("Offender.nanos")
                .withMessageContaining("Offender.sleep")
                .satisfies(e -> assertThat(e.getMessage()).doesNotContain("Excused"));
    }

    @Test
    void findTheJdksOwnTimer() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::timeLimitsAreTheSchedulers)
                .withMessageContaining("Offender.timeout");
    }

    @Test
    void findTheCommonPool() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::nothingRunsInTheCommonPool)
                .withMessageContaining("Offender.async")
                .withMessageContaining("Offender.parallel");
    }

    @Test
    void findRandomNumbers() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::randomnessIsHandedIn)
                .withMessageContaining("Offender.random")
                .withMessageContaining("Offender.unseeded")
                .satisfies(e -> assertThat(e.getMessage()).doesNotContain("Offender.seeded"));
    }

    @Test
    void findTheConsole() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::onlyTheCommandLineTalksToTheConsole)
                .withMessageContaining("Offender.print");
    }

    private static final class Rules extends ArchitectureRules {
        Rules() {
            super(ArchitectureRulesTest.class);
        }
    }

    @SuppressWarnings("unused")
    private static final class Offender {
        Instant instant() {
            return Instant.now();
        }

        long nanos() {
            return System.nanoTime();
        }

        void sleep() throws InterruptedException {
            Thread.sleep(1);
        }

        CompletableFuture<String> timeout(CompletableFuture<String> future) {
            return future.orTimeout(1, TimeUnit.SECONDS);
        }

        CompletableFuture<String> async(CompletableFuture<String> future) {
            return future.thenApplyAsync(String::trim);
        }

        long parallel(List<String> list) {
            return list.parallelStream().count();
        }

        double random() {
            return Math.random();
        }

        Random unseeded() {
            return new Random();
        }

        Random seeded() {
            return new Random(1);
        }

        void print() {
            System.out.println();
        }
    }

    @SuppressWarnings("unused")
    @AllowedToReadWallClock("a test of the mark")
    private static final class Excused {
        private static final class Inner {
            Instant instant() {
                return Instant.now();
            }
        }
    }
}
