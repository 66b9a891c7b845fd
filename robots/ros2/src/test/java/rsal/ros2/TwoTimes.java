package rsal.ros2;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// A run that follows the time of a simulator.
///
/// @param real time
/// @param ofSimulator the time of the run
public record TwoTimes(Scheduler real, Scheduler ofSimulator) implements Scheduler {
    @Override
    public Scheduler inRealTime() {
        return real;
    }

    @Override
    public Instant instant() {
        return ofSimulator.instant();
    }

    @Override
    public void execute(Runnable task) {
        real.execute(task);
    }

    @Override
    public Task after(Duration delay, Phase phase, Runnable task) {
        return ofSimulator.after(delay, phase, task);
    }

    @Override
    public Task every(Duration period, Phase phase, Runnable task) {
        return ofSimulator.every(period, phase, task);
    }

    @Override
    public <T> CompletionStage<T> compute(Supplier<T> work) {
        return ofSimulator.compute(work);
    }
}
