package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.device.GoalHandle;

/// Pauses between and within steps.
class PausingTest {
    private int resumes;
    private final Pausing pausing = new Pausing(true, () -> Instant.EPOCH, () -> resumes++);

    @Test
    void aPauseBetweenStepsStandsAtOnce() {
        assertThat(pausing.pause().toCompletableFuture()).isCompleted();
        assertThat(pausing.isWaiting()).isTrue();
        assertThat(pausing.isCompleting()).isFalse();
    }

    @Test
    void aPauseWithinAStepStandsWhenThatIsComplete() {
        pausing.stepBegun();
        var standing = pausing.pause().toCompletableFuture();
        assertThat(standing).isNotDone();
        assertThat(pausing.isWaiting()).isFalse();
        assertThat(pausing.isCompleting()).isTrue();
        pausing.stepped();
        assertThat(standing).isCompleted();
        assertThat(pausing.isWaiting()).isTrue();
    }

    @Test
    void aPauseIsOverWhenTheRunIsResumedBefore() {
        pausing.stepBegun();
        var standing = pausing.pause().toCompletableFuture();
        pausing.resume();
        assertThat(standing).isCompleted();
        assertThat(pausing.isPaused()).isFalse();
        assertThat(resumes).isEqualTo(1);
    }

    @Test
    void aRunThatCantBePausedGoesOn() {
        var real = new Pausing(false, () -> Instant.EPOCH, () -> {});
        real.stepBegun();
        assertThat(real.pause().toCompletableFuture()).isCompleted();
        assertThat(real.isPaused()).isFalse();
    }

    @Test
    void theRestOfAStepIsNoneOfThoseThatAreWanted() {
        pausing.stepBegun();
        pausing.pause();
        GoalHandle<Long, Long> steps = pausing.step(2);
        List<Long> reported = new ArrayList<>();
        steps.onFeedback(made -> reported.add(made.value()));
        pausing.stepped();
        assertThat(reported).as("the rest").isEmpty();
        pausing.stepBegun();
        assertThat(pausing.isCompleting()).as("within one that is wanted").isFalse();
        pausing.stepped();
        pausing.stepped();
        assertThat(reported).containsExactly(1L, 2L);
        assertThat(steps.result().toCompletableFuture()).isCompletedWithValue(2L);
        assertThat(pausing.isWaiting()).isTrue();
    }

    @Test
    void aPersonsStepIsAWholeOne() {
        pausing.stepBegun();
        pausing.pause();
        pausing.step();
        pausing.stepped();
        assertThat(pausing.isWaiting()).as("that was the rest").isFalse();
        pausing.stepped();
        assertThat(pausing.isWaiting()).isTrue();
    }
}
