package rsal.ros2.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Thing;
import rsal.system.RunControl;
import rsal.time.Scheduler;

/// Control of a run that only a test lets go on.
final class FakeRunControl implements RunControl {
    private final SimulationControl world;
    private final Scheduler scheduler;
    final List<String> reported = new ArrayList<>();
    boolean pausable = true;
    boolean paused;
    CompletableFuture<Void> standing = CompletableFuture.completedFuture(null); // once it is paused
    Optional<GoalSource<Long, Long>> steps = Optional.empty();

    FakeRunControl(SimulationControl world, Scheduler scheduler) {
        this.world = world;
        this.scheduler = scheduler;
    }

    /// Steps are made of those that are wanted.
    void make(long... counts) {
        for (long count : counts) {
            steps.orElseThrow().publish(new Stamped<>(scheduler.instant(), "", count));
        }
    }

    /// They are over.
    void end(long made) {
        GoalSource<Long, Long> ended = steps.orElseThrow();
        steps = Optional.empty();
        ended.end(made);
    }

    @Override
    public void execute(Runnable work) {
        scheduler.execute(work);
    }

    @Override
    public boolean isPausable() {
        return pausable;
    }

    @Override
    public boolean isPaused() {
        return paused;
    }

    @Override
    public CompletionStage<Void> pause() {
        paused = true;
        return standing;
    }

    @Override
    public void resume() {
        paused = false;
    }

    @Override
    public void end() {
        reported.add("end");
    }

    @Override
    public GoalHandle<Long, Long> step(long count) {
        if (steps.isPresent()) {
            throw new IllegalStateException("busy");
        }
        reported.add("step " + count);
        var goal = new GoalSource<Long, Long>(() -> end(0));
        steps = Optional.of(goal);
        return goal;
    }

    @Override
    public List<Spawnable> spawnables() {
        return List.of(new Spawnable("pioneer", "A robot.", true), new Spawnable("puck", "A thing.", false));
    }

    @Override
    public boolean isFree(String name) {
        return !world.entities().contains(name);
    }

    @Override
    public Placement spawn(String kind, String name, Pose2d mapFromEntity) {
        reported.add("spawn " + kind + " " + name);
        return kind.equals("puck")
                ? world.add(Thing.of(
                        name,
                        mapFromEntity,
                        Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.08), 0.16),
                        new Rgb(0, 0, 0)))
                : world.addRobot(name, "r1", mapFromEntity);
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        return world.place(entity, mapFromEntity);
    }

    @Override
    public Placement remove(String entity) {
        return world.remove(entity) || world.removeRobot(entity)
                ? new Placement.Placed()
                : new Placement.Refused("There is no '%s'.".formatted(entity));
    }

    @Override
    public void removeSpawned() {
        reported.add("remove spawned");
    }

    @Override
    public List<String> restore() {
        reported.add("restore");
        return reported.contains("remove b1") ? List.of("b1") : List.of();
    }
}
