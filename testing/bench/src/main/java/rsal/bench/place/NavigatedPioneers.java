package rsal.bench.place;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.device.SimulationControl;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.system.RobotSystem;
import rsal.time.LockstepScheduler;

/// Pioneers that are told where they start, and drive by `amcl` and a navigator.
public final class NavigatedPioneers implements AutoCloseable {
    public final LockstepScheduler time;
    public final List<Robot> robots = new ArrayList<>();
    private final RobotSystem system;
    private final SimulationControl simulation;

    /// @param floor that they stand on
    /// @param believed the map that they are given of it
    /// @param settings of the navigators
    /// @param random of their devices
    public NavigatedPioneers(
            OccupancyGrid floor,
            OccupancyGrid believed,
            List<Pose2d> starts,
            Map<String, ?> settings,
            long seed,
            SplittableRandom random,
            Executor workers) {
        time = new LockstepScheduler(Instant.EPOCH, workers);
        system = Pioneers.open(floor, starts, Pioneers.LASER, seed, time);
        simulation = system.simulation().orElseThrow();
        DeviceDriver amcl = Pioneers.driver("amcl");
        DeviceDriver navigator = Pioneers.driver("navigator");
        for (Robot robot : system.discover().toCompletableFuture().join()) {
            Optional<Pose2d> start = simulation.truth(robot.id());
            Robot localized = Pioneers.equip(robot, amcl, Map.of(), believed, start, time, random);
            robots.add(Pioneers.equip(localized, navigator, settings, believed, start, time, random));
        }
    }

    public static Navigator navigator(Robot robot) {
        return robot.require(Navigator.class);
    }

    /// Where a robot really is.
    public Pose2d truth(Robot robot) {
        return simulation.truth(robot.id()).orElseThrow();
    }

    /// How often robots touched something.
    public int contacts() {
        return simulation.contacts().size();
    }

    @Override
    public void close() {
        system.close();
    }
}
