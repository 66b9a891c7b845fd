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
import rsal.model.RobotModels;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider.Config;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.testkit.DrawnMap;
import rsal.testkit.ObviousRays;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Robots that do exactly as told, every 0.1 s, in a world of walls and things. Bodies are discs of the
/// footprint's inscribed radius; robots neither see nor touch each other, and range sensors see walls only.
public final class FakeSystem implements RobotSystem {
    static final Duration STEP = Duration.ofMillis(100);
    static final double STEP_SECONDS = 0.1;

    private final Scheduler scheduler;
    private final List<Robot> robots = new ArrayList<>();
    private final List<FakeDriveBase> bases = new ArrayList<>();
    private final List<FakeSensor<?>> sensors = new ArrayList<>();
    private final FakeWorld world;
    private final FakeSimulationControl simulation;
    private final Listeners<Change> listeners = new Listeners<>(e -> {
        throw e;
    });
    private @Nullable Task steps;
    private boolean closed;

    FakeSystem(Config config, Scheduler scheduler) {
        this.scheduler = scheduler;
        this.world = new FakeWorld(new ObviousRays(config.scene().map()));
        var problems = new ArrayList<InvalidRobots.Problem>();
        for (RobotSpec spec : config.robots()) {
            Pose2d start = spec.mapFromBase().orElse(Pose2d.ORIGIN);
            if (!config.scene().map().isFree(start.x(), start.y())) {
                problems.add(new InvalidRobots.Problem(
                        spec.id(), "pose", "(%s, %s) is not free.".formatted(start.x(), start.y())));
            }
            robots.add(build(spec, start));
        }
        if (!problems.isEmpty()) {
            throw new InvalidRobots(problems);
        }
        simulation = new FakeSimulationControl(bases, world, config.scene().map());
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
        return new FakeSystem(new Config(Arguments.defaults(List.of()), Scene.of(map.grid()), specs, 1), scheduler);
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
    public void publish(Change change) {
        listeners.publish(change);
    }

    @Override
    public Optional<SimulationControl> simulation() {
        return Optional.of(simulation);
    }

    @Override
    public void close() {
        closed = true;
        bases.forEach(FakeDriveBase::halt);
        sensors.forEach(FakeSensor::shutDown);
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
        sensors.forEach(FakeSensor::sense);
    }

    private Robot build(RobotSpec spec, Pose2d start) {
        var base = new FakeDriveBase(info(spec, "base"), spec.model(), start, world, scheduler);
        bases.add(base);
        var devices = new ArrayList<Device>(List.of(base));
        spec.model().sensors().forEach((name, part) -> {
            FakeSensor<?> sensor = sensor(info(spec, name), part, base);
            sensors.add(sensor);
            devices.add(sensor);
        });
        return new Robot(spec.id(), spec.role(), spec.model(), spec.marker(), devices);
    }

    private FakeSensor<?> sensor(DeviceInfo info, Part part, FakeDriveBase base) {
        return switch (part) {
            case Part.Laser laser -> new FakeLaserScanner(info, laser, base, world.rays(), scheduler);
            case Part.Sonars sonars -> new FakeSonarArray(info, sonars, base, world.rays(), scheduler);
            case Part.BlobFinder camera -> new FakeBlobFinder(info, camera, base, world, scheduler);
            case Part.FiducialFinder finder -> new FakeFiducialFinder(info, finder, base, world, scheduler);
            case Part.Gripper gripper -> new FakeGripper(info, gripper, base, world, scheduler);
            case Part.Bumper bumper -> new FakeBumper(info, bumper, base, world, scheduler);
            case Part.Actuator actuator -> new FakeActuator(info, actuator, base, scheduler);
            case Part.Battery battery -> new FakeBattery(info, battery, base, world, scheduler);
            case Part.Light light -> new FakeLight(info, light, scheduler);
            case Part.Registered other ->
                throw new IllegalArgumentException("'%s' is not faked.".formatted(other.name()));
            case Part.Own own -> throw new IllegalArgumentException("'%s' is not faked.".formatted(own.name()));
        };
    }

    private static DeviceInfo info(RobotSpec spec, String name) {
        return new DeviceInfo(spec.id(), name, "fake");
    }
}
