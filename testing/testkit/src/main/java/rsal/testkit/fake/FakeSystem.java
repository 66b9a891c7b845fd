package rsal.testkit.fake;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Listeners;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModels;
import rsal.robot.RobotSpec;
import rsal.robot.RobotSystem;
import rsal.robot.RobotSystemProvider.Config;
import rsal.robot.RobotSystemProvider.InvalidRobots;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.DrawnMap;
import rsal.testkit.Rays;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Robots that do exactly as told, every 0.1 s, in a world of walls. Bodies are discs of the footprint's inscribed
/// radius; robots neither see nor touch each other.
public final class FakeSystem implements RobotSystem {
    static final Duration STEP = Duration.ofMillis(100);

    private final Scheduler scheduler;
    private final List<Robot> robots = new ArrayList<>();
    private final List<FakeDriveBase> bases = new ArrayList<>();
    private final List<Runnable> sensing = new ArrayList<>();
    private final FakeSimulationControl simulation;
    private final Listeners<Change> listeners = new Listeners<>(e -> {
        throw e;
    });
    private @Nullable Task steps;
    private boolean closed;

    FakeSystem(Config config, Scheduler scheduler) {
        this.scheduler = scheduler;
        var rays = new Rays(config.world());
        var problems = new ArrayList<InvalidRobots.Problem>();
        for (RobotSpec spec : config.robots()) {
            Pose2d start = spec.mapFromBase().orElse(Pose2d.ORIGIN);
            if (!config.world().isFree(start.x(), start.y())) {
                problems.add(new InvalidRobots.Problem(
                        spec.id(), "pose", "(%s, %s) is not free.".formatted(start.x(), start.y())));
            }
            robots.add(build(spec, start, rays));
        }
        if (!problems.isEmpty()) {
            throw new InvalidRobots(problems);
        }
        simulation = new FakeSimulationControl(bases, config.world());
    }

    /// A system with robots of the model Pioneer 2-DX with a laser, named `r1`, `r2`… at poses.
    public static FakeSystem pioneers(Scheduler scheduler, DrawnMap map, Pose2d... mapFromBases) {
        RobotModel model = new RobotModels(FileSource.resources(FakeSystem.class, "/"))
                .read(
                        "pioneer2dx",
                        Location.of("test"),
                        java.util.Map.of("laser", new RobotModels.Choice("urg04lx", Location.of("test"))));
        var specs = new ArrayList<RobotSpec>();
        for (Pose2d mapFromBase : mapFromBases) {
            specs.add(new RobotSpec("r" + (specs.size() + 1), "robot", model, Optional.of(mapFromBase), "#808080"));
        }
        return new FakeSystem(new Config(Arguments.defaults(List.of()), map.grid(), specs, 1), scheduler);
    }

    /// The robots, known without discovering. They move and sense once [#discover] was called.
    public List<Robot> robots() {
        return List.copyOf(robots);
    }

    @Override
    public CompletionStage<List<Robot>> discover() {
        if (steps == null && !closed) {
            steps = scheduler.every(STEP, Phase.WORLD, this::step);
        }
        return CompletableFuture.completedStage(List.copyOf(robots));
    }

    @Override
    public Subscription onChange(Consumer<? super Change> listener) {
        return listeners.add(listener);
    }

    /// For tests: a robot appears or goes.
    public void tell(Change change) {
        listeners.tell(change);
    }

    @Override
    public Optional<SimulationControl> simulation() {
        return Optional.of(simulation);
    }

    @Override
    public void close() {
        closed = true;
        bases.forEach(FakeDriveBase::halt);
        if (steps != null) {
            steps.cancel();
        }
    }

    private void step() {
        for (FakeDriveBase base : bases) {
            base.step(simulation);
        }
        for (FakeDriveBase base : bases) {
            base.sense();
        }
        sensing.forEach(Runnable::run);
    }

    private Robot build(RobotSpec spec, Pose2d start, Rays rays) {
        var base = new FakeDriveBase(info(spec, "base"), spec.model(), start, rays, scheduler);
        bases.add(base);
        var devices = new ArrayList<Device>(List.of(base));
        spec.model().sensors().forEach((name, part) -> {
            switch (part) {
                case Part.Laser laser -> {
                    var device = new FakeLaserScanner(info(spec, name), laser, base, rays, scheduler);
                    sensing.add(device::sense);
                    devices.add(device);
                }
                case Part.Sonars sonars -> {
                    var device = new FakeSonarArray(info(spec, name), sonars, base, rays, scheduler);
                    sensing.add(device::sense);
                    devices.add(device);
                }
            }
        });
        return new Robot(spec.id(), spec.role(), spec.model(), devices);
    }

    private static DeviceInfo info(RobotSpec spec, String name) {
        return new DeviceInfo(spec.id(), name, "fake");
    }
}
