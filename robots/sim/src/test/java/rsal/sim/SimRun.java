package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.device.SimulationControl;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider.Config;
import rsal.testkit.DrawnMap;
import rsal.time.LockstepScheduler;

/// A simulation under test, and the clock that drives it.
final class SimRun {
    final LockstepScheduler scheduler;
    final RobotSystem system;
    final List<Robot> robots;
    final SimulationControl simulation;

    private SimRun(Scene scene, Map<String, ?> settings, long seed, Executor workers, List<RobotSpec> specs) {
        scheduler = new LockstepScheduler(Instant.EPOCH, workers);
        var provider = new SimProvider();
        var arguments = Arguments.of(provider.parameters(), settings);
        system = provider.create(new Config(arguments, scene, specs, seed), scheduler);
        robots = ended(system.discover());
        simulation = system.simulation().orElseThrow();
    }

    static SimRun of(OccupancyGrid map, Map<String, ?> settings, RobotSpec... robots) {
        return new SimRun(Scene.of(map), settings, 1, Runnable::run, List.of(robots));
    }

    static SimRun in(Scene scene, RobotSpec... robots) {
        return new SimRun(scene, Map.of(), 1, Runnable::run, List.of(robots));
    }

    /// In a world with things.
    static SimRun of(OccupancyGrid map, List<Entity> things, RobotSpec... robots) {
        Scene bare = Scene.of(map);
        var scene = new Scene(
                "",
                map,
                Optional.empty(),
                Optional.empty(),
                bare.touch(),
                bare.walls(),
                things,
                List.of(),
                Map.of(),
                Map.of(),
                Map.of(),
                bare.contents(),
                List.of(),
                List.of());
        return in(scene, robots);
    }

    static SimRun of(OccupancyGrid map, RobotSpec... robots) {
        return of(map, Map.of(), robots);
    }

    static SimRun seeded(OccupancyGrid map, long seed, Executor workers, List<RobotSpec> robots) {
        return new SimRun(Scene.of(map), Map.of(), seed, workers, robots);
    }

    /// An empty room with walls of 0.1 m; its outer lower left corner is the origin.
    static OccupancyGrid room(double length, double depth) {
        int columns = (int) Math.round(length * 10);
        int rows = (int) Math.round(depth * 10);
        String wall = "#".repeat(columns) + "\n";
        String between = "#" + ".".repeat(columns - 2) + "#\n";
        return DrawnMap.grid(0.1, wall + between.repeat(rows - 2) + wall).grid();
    }

    static RobotSpec robot(String id, RobotModel model, Pose2d mapFromBase) {
        return new RobotSpec(id, "robot", model, Optional.of(mapFromBase), "#000000");
    }

    static RobotSpec anywhere(String id, RobotModel model) {
        return new RobotSpec(id, "robot", model, Optional.empty(), "#000000");
    }

    Robot robot(String id) {
        return robots.stream().filter(r -> r.id().equals(id)).findFirst().orElseThrow();
    }

    DriveBase base(String id) {
        return robot(id).require(DriveBase.class);
    }

    Pose2d truth(String id) {
        return simulation.truth(id).orElseThrow();
    }

    void advance(double seconds) {
        scheduler.advance(Duration.ofNanos(Math.round(seconds * 1e9)));
    }

    static <T> T ended(CompletionStage<T> stage) {
        assertThat(stage.toCompletableFuture()).isCompleted();
        return stage.toCompletableFuture().join();
    }
}
