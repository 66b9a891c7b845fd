package rsal.testkit.architecture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Instant;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
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
                .withMessageContaining("Offender.doze")
                .withMessageContaining("Offender.park")
                .withMessageContaining("Offender.handsOutTheClock")
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
                .withMessageContaining("Offender.parallel")
                .withMessageContaining("Offender.sort");
    }

    @Test
    void findRandomNumbers() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::randomnessIsHandedIn)
                .withMessageContaining("Offender.random")
                .withMessageContaining("Offender.unseeded")
                .withMessageContaining("Offender.handsOutRandomness")
                .withMessageContaining("Offender.shuffle")
                .satisfies(e -> assertThat(e.getMessage()).doesNotContain("Offender.seeded"));
    }

    @Test
    void findTheConsole() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::onlyTheCommandLineTalksToTheConsole)
                .withMessageContaining("Offender.print");
    }

    @Test
    void findAgentsAndRobotSystemsThatSeeEachOther() {
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::agentsDoNotSeeWhereRobotsComeFrom)
                .withMessageContaining("rsal.agents.offending.Seer");
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::robotSystemsDoNotSeeAgents)
                .withMessageContaining("rsal.sim.offending.Seen");
        assertThatExceptionOfType(AssertionError.class)
                .isThrownBy(rules::packagesKnowEachOtherOneWayOnly)
                .withMessageContainingAll("rsal.agents.offending", "rsal.sim.offending");
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

        void doze() throws InterruptedException {
            TimeUnit.SECONDS.sleep(1);
        }

        void park() {
            LockSupport.parkNanos(1);
        }

        Supplier<Instant> handsOutTheClock() {
            return Instant::now;
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

        void sort(double[] values) {
            Arrays.parallelSort(values);
        }

        double random() {
            return Math.random();
        }

        Random unseeded() {
            return new Random();
        }

        Supplier<Random> handsOutRandomness() {
            return Random::new;
        }

        void shuffle(List<String> list) {
            Collections.shuffle(list);
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
