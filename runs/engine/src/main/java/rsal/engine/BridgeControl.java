package rsal.engine;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.stream.Stream;
import rsal.data.Pose2d;
import rsal.device.GoalHandle;
import rsal.device.SimulationControl.Placement;
import rsal.engine.report.Answer;
import rsal.engine.report.PlacedThing;
import rsal.engine.world.SimulatedWorld;
import rsal.model.RobotModels;
import rsal.system.RunControl;

/// A run as the programs behind one bridge control it.
final class BridgeControl implements RunControl {
    private final RunLoop loop;
    private final SimulatedWorld world;
    private final String operator;
    private final Set<String> spawned = new LinkedHashSet<>();

    /// @param operator in whose name the world is changed
    BridgeControl(RunLoop loop, SimulatedWorld world, String operator) {
        this.loop = loop;
        this.world = world;
        this.operator = operator;
    }

    /// Read when they are asked for, as most bridges don't.
    private static final class Kinds {
        static final List<Spawnable> ALL = Stream.concat(
                        RobotModels.readBuiltIn().stream()
                                .map(model ->
                                        new Spawnable(model.name(), "A robot: %s.".formatted(model.title()), true)),
                        Arrays.stream(PlacedThing.values()).map(BridgeControl::spawnable))
                .toList();
    }

    private static Spawnable spawnable(PlacedThing thing) {
        String description = switch (thing) {
            case BOX -> "A box of 0.5 m, an obstacle.";
            case BALL -> "A ball of 0.16 m, which grippers can hold.";
        };
        return new Spawnable(word(thing), description, false);
    }

    private static String word(PlacedThing thing) {
        return thing.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public void execute(Runnable work) {
        Operator.tells(
                operator,
                () -> loop.ask(_ -> {
                    work.run();
                    return new Answer.Done();
                }));
    }

    @Override
    public boolean isPausable() {
        return loop.pausing().isPossible();
    }

    @Override
    public boolean isPaused() {
        return loop.pausing().isPaused();
    }

    @Override
    public CompletionStage<Void> pause() {
        return loop.pausing().pause();
    }

    @Override
    public void resume() {
        loop.pausing().resume();
    }

    @Override
    public void end() {
        loop.stop();
    }

    @Override
    public GoalHandle<Long, Long> step(long count) {
        return loop.pausing().step(count);
    }

    @Override
    public List<Spawnable> spawnables() {
        return Kinds.ALL;
    }

    @Override
    public boolean isFree(String name) {
        return world.isFree(name);
    }

    @Override
    public Placement spawn(String kind, String name, Pose2d mapFromEntity) {
        Optional<PlacedThing> thing = Arrays.stream(PlacedThing.values())
                .filter(each -> word(each).equals(kind))
                .findFirst();
        Placement placement = placement(thing.map(each -> world.add(each, Optional.of(name), mapFromEntity))
                .orElseGet(() -> world.newRobot(kind, Optional.of(name), mapFromEntity)));
        if (placement instanceof Placement.Placed) {
            spawned.add(name);
        }
        return placement;
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        return placement(world.place(entity, mapFromEntity));
    }

    @Override
    public Placement remove(String entity) {
        Placement removed = placement(world.remove(entity));
        spawned.remove(entity);
        return removed;
    }

    @Override
    public void removeSpawned() {
        List.copyOf(spawned).forEach(this::remove);
    }

    @Override
    public List<String> restore() {
        return world.restore();
    }

    private static Placement placement(Answer answer) {
        return answer instanceof Answer.Refused(String why) ? new Placement.Refused(why) : new Placement.Placed();
    }
}
