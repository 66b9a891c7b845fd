package rsal.engine;

import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Stamped;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;

/// Whether a run stands still, and for how many steps it goes on nevertheless. Of the run's thread.
final class Pausing {
    private final boolean isPossible;
    private final InstantSource clock;
    private final Runnable onResume;
    private volatile boolean paused;
    private boolean isWithinStep;
    private boolean isRest; // what is left of the step under way, before those that are wanted
    private CompletableFuture<Void> standing = new CompletableFuture<>(); // when it is next paused between two steps
    private long wanted; // steps of people
    private Optional<Stepping> stepping = Optional.empty();

    /// Steps that somebody waits for.
    private static final class Stepping {
        private final GoalSource<Long, Long> goal;
        private final long count;
        private long made;

        Stepping(GoalSource<Long, Long> goal, long count) {
            this.goal = goal;
            this.count = count;
        }
    }

    /// @param isPossible whether the run can be paused at all
    /// @param clock the run's
    Pausing(boolean isPossible, InstantSource clock, Runnable onResume) {
        this.isPossible = isPossible;
        this.clock = clock;
        this.onResume = onResume;
    }

    boolean isPossible() {
        return isPossible;
    }

    /// Any thread may ask.
    boolean isPaused() {
        return paused;
    }

    /// Whether it has to wait.
    boolean isWaiting() {
        return paused && !isWithinStep && isIdle();
    }

    /// Whether it is paused, and only completes a step. It waits for nobody then: who paused it may be the one that
    /// would be waited for.
    boolean isCompleting() {
        return paused && isWithinStep && isIdle();
    }

    private boolean isIdle() {
        return wanted == 0 && stepping.isEmpty();
    }

    /// @return when the step is complete that is being made, or it was resumed
    CompletionStage<Void> pause() {
        paused = isPossible;
        if (!isPossible || !isWithinStep) {
            return CompletableFuture.completedStage(null);
        }
        return standing.minimalCompletionStage();
    }

    private void stand() {
        CompletableFuture<Void> before = standing;
        standing = new CompletableFuture<>();
        before.complete(null);
    }

    /// A part of a step was made, and there is more of it.
    void stepBegun() {
        isWithinStep = true;
    }

    void resume() {
        paused = false;
        isRest = false;
        endStepping();
        onResume.run();
        stand();
    }

    /// Ends it early, if somebody waits for steps.
    void endStepping() {
        Optional<Stepping> ended = stepping;
        stepping = Optional.empty();
        ended.ifPresent(steps -> steps.goal.end(steps.made));
    }

    /// One more step, while it is paused.
    void step() {
        if (paused) {
            noteRest();
            wanted++;
        }
    }

    /// What is left of a step that was begun before is none of those that are wanted.
    private void noteRest() {
        isRest |= isCompleting();
    }

    /// As [rsal.system.RunControl#step].
    GoalHandle<Long, Long> step(long count) {
        if (!paused || stepping.isPresent()) {
            throw new IllegalStateException("It can't be stepped now.");
        }
        noteRest();
        var goal = new GoalSource<Long, Long>(this::endStepping);
        stepping = Optional.of(new Stepping(goal, count));
        return goal;
    }

    /// A step was made, or the rest of it.
    void stepped() {
        isWithinStep = false;
        stand();
        if (isRest) {
            isRest = false;
            return;
        }
        wanted = Math.max(0, wanted - 1);
        stepping.ifPresent(steps -> {
            steps.made++;
            steps.goal.publish(new Stamped<>(clock.instant(), "", steps.made));
            if (steps.made >= steps.count) {
                endStepping();
            }
        });
    }
}
