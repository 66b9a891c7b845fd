package rsal.ros2.simulation;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import rsal.ros2.action.ActionTime;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// A run's scheduler with the time that programs of ROS see. That is the run's, until a program resets it: then it
/// begins again at 0, while the run's own goes on. Of the run's thread.
public final class PublishedTime implements ActionTime {
    private final Scheduler run;
    private Duration behind = Duration.ZERO; // the run's time

    public PublishedTime(Scheduler run) {
        this.run = run;
    }

    /// It is 0 now.
    public void restart() {
        behind = Duration.between(Instant.EPOCH, run.instant());
    }

    @Override
    public Instant ofRun() {
        return run.instant();
    }

    /// Also, 0 for what was before the last reset.
    @Override
    public Instant stamp(Instant ofRun) {
        Instant published = ofRun.minus(behind);
        return published.isBefore(Instant.EPOCH) && !behind.isZero() ? Instant.EPOCH : published;
    }

    @Override
    public Instant instant() {
        return stamp(run.instant());
    }

    @Override
    public Scheduler inRealTime() {
        return run.inRealTime();
    }

    @Override
    public Object run() {
        return run.run();
    }

    @Override
    public void execute(Runnable task) {
        run.execute(task);
    }

    @Override
    public void exclusively(Runnable task) {
        run.exclusively(task);
    }

    @Override
    public Task after(Duration delay, Phase phase, Runnable task) {
        return run.after(delay, phase, task);
    }

    @Override
    public Task every(Duration period, Phase phase, Runnable task) {
        return run.every(period, phase, task);
    }

    @Override
    public <T> CompletionStage<T> compute(Supplier<T> work) {
        return run.compute(work);
    }
}
