package rsal.engine.world;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.engine.event.EventLog;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.settings.Parameter;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.FakeProvider;
import rsal.time.Scheduler;

/// Fakes whose sensors are overlaid with a world in which there is nobody else.
final class Overlaid implements RobotSystemProvider {
    @Override
    public String key() {
        return "overlaid";
    }

    @Override
    public String description() {
        return "Fakes that sense an empty world.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of();
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        var eventLog = new EventLog(() -> Duration.ZERO, () -> {});
        RobotSystem fakes = new FakeProvider().create(config, scheduler);
        return new RobotSystem() {
            @Override
            public CompletionStage<List<Robot>> discover() {
                return fakes.discover()
                        .thenApply(robots -> robots.stream().map(this::over).toList());
            }

            private Robot over(Robot robot) {
                var spec = new RobotSpec(robot.id(), robot.role(), robot.model(), Optional.empty(), "#808080");
                Set<String> itself = Set.of(robot.id());
                return new Overlay(spec, () -> truth(robot.id()), fakes::simulation, () -> itself, eventLog)
                        .over(robot);
            }

            private Optional<Stamped<Pose2d>> truth(String robot) {
                return fakes.simulation()
                        .flatMap(world -> world.truth(robot))
                        .map(mapFromBase -> new Stamped<>(scheduler.instant(), "map", mapFromBase));
            }

            @Override
            public Subscription onChange(Consumer<? super Change> listener) {
                return fakes.onChange(listener);
            }

            @Override
            public Optional<SimulationControl> simulation() {
                return fakes.simulation();
            }

            @Override
            public void close() {
                fakes.close();
            }
        };
    }
}
