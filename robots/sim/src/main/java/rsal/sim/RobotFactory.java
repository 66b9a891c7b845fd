package rsal.sim;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotSpec;
import rsal.robot.SimulationLimits;
import rsal.settings.Arguments;
import rsal.sim.device.SimulatedKind;
import rsal.sim.device.SimulatedSensor;
import rsal.sim.world.Body;
import rsal.sim.world.CameraRays;
import rsal.sim.world.SensorRays;
import rsal.sim.world.World;
import rsal.time.Scheduler;

/// Makes robots of their parts. Robots of one kind share what does not change.
final class RobotFactory {
    private final Arguments settings;
    private final Scheduler scheduler;
    private final RandomStreams seeds;
    private final World world;
    private final Things things;
    private final Map<Kind, SensorRays> beams = new HashMap<>();
    private final Map<Kind, CameraRays> views = new HashMap<>();

    private static final Map<Class<? extends Device>, SimulatedKind> KINDS =
            ServiceLoader.load(SimulatedKind.class).stream()
                    .map(ServiceLoader.Provider::get)
                    .collect(Collectors.toUnmodifiableMap(SimulatedKind::makes, kind -> kind));

    /// @param height above the base [m]
    private record Kind(Part part, double height) {}

    RobotFactory(Arguments settings, Scheduler scheduler, RandomStreams seeds, World world, Things things) {
        this.settings = settings;
        this.scheduler = scheduler;
        this.seeds = seeds;
        this.world = world;
        this.things = things;
    }

    /// A robot while its devices are made.
    ///
    /// @param mounts on its actuators, by device
    private record Site(
            RobotSpec spec,
            Body body,
            SimDrive drive,
            Map<String, SimActuator> actuators,
            Map<String, DeviceMount> mounts) {
        DeviceMount mount(String device) {
            String on = spec.model().carriers().get(device);
            return on == null ? DeviceMount.BASE : mounts.computeIfAbsent(on, _ -> new DeviceMount(carriersOf(device)));
        }

        private List<SimActuator> carriersOf(String device) {
            return spec.model().carriersOf(device).stream().map(this::actuator).toList();
        }

        SimActuator actuator(String name) {
            return Objects.requireNonNull(actuators.get(name), name);
        }
    }

    SimRobot robot(RobotSpec spec, Body body) {
        SimDrive drive = drive(spec);
        var site = new Site(spec, body, drive, actuators(spec, drive), new HashMap<>());
        var devices = new ArrayList<SimSensor<?>>();
        spec.model().sensors().forEach((name, part) -> devices.add(device(site, name, part)));
        giveLimbs(site);
        return SimRobot.of(spec, body, site.drive, devices, List.copyOf(site.mounts.values()));
    }

    /// Lets actuators carry what of the body stands on them, or on what they carry.
    private void giveLimbs(Site site) {
        if (site.body.carriers().isEmpty()) {
            return;
        }
        RobotModel model = site.spec.model();
        var mounts = new ArrayList<DeviceMount>();
        var moving = new LinkedHashSet<String>();
        for (String carrier : site.body.carriers()) {
            boolean there = site.actuators.containsKey(carrier);
            var chain = new ArrayList<>(there ? model.carriersOf(carrier) : List.<String>of());
            if (there) {
                chain.add(carrier);
            }
            moving.addAll(chain);
            mounts.add(new DeviceMount(chain.stream().map(site::actuator).toList()));
        }
        var bending = new ArticulatedMotion(world, site.body, List.copyOf(mounts));
        moving.forEach(name -> site.actuator(name).bend(bending, site.mount(name)));
    }

    private Map<String, SimActuator> actuators(RobotSpec spec, SimDrive drive) {
        var actuators = new HashMap<String, SimActuator>();
        spec.model().sensors().forEach((name, part) -> {
            if (part instanceof Part.Actuator actuator) {
                actuators.put(name, new SimActuator(deviceOf(spec, name), actuator, drive, scheduler, watchdog()));
            }
        });
        return actuators;
    }

    private SimDrive drive(RobotSpec spec) {
        var drive = spec.model().drive();
        return new SimDrive(
                deviceOf(spec, "base"),
                scheduler,
                watchdog(),
                new WheelSpeeds(drive),
                new Odometer(
                        drive.odometryNoise(),
                        settings.get(SimProvider.ODOMETRY_NOISE),
                        seeds.stream(spec.id() + "/base")));
    }

    private SimSensor<?> device(Site site, String name, Part part) {
        DeviceInfo info = deviceOf(site.spec, name);
        double height = site.spec.model().level(name);
        DeviceMount mount = site.mount(name);
        var kind = new Kind(part, height);
        return switch (part) {
            case Part.Laser laser ->
                new SimLaser(
                        info,
                        laser,
                        beams.computeIfAbsent(kind, _ -> SimLaser.beams(laser, height)),
                        mount,
                        noise(info, laser.noise()));
            case Part.Sonars sonars ->
                new SimSonar(
                        info,
                        sonars,
                        beams.computeIfAbsent(kind, _ -> SimSonar.cones(sonars, height)),
                        mount,
                        noise(info, sonars.noise()));
            case Part.BlobFinder finder ->
                new SimBlobFinder(
                        info, finder, views.computeIfAbsent(kind, _ -> SimBlobFinder.view(finder, height)), mount);
            case Part.FiducialFinder finder -> new SimFiducialFinder(info, finder, height, mount);
            case Part.Gripper gripper ->
                new SimGripper(info, gripper, world, things, site.body, site.drive, height, mount);
            case Part.Bumper bumper -> new SimBumper(info, bumper, world, site.body, height, mount);
            case Part.Actuator _ -> site.actuator(name);
            case Part.Battery battery -> new SimBattery(info, battery, site.body, site.drive);
            case Part.Light light -> new SimLight(info, light, scheduler);
            case Part.Registered other -> registered(info, other, site, height, mount);
            case Part.Own own -> throw new IllegalArgumentException("'%s' was refused before.".formatted(own.name()));
        };
    }

    private SimSensor<?> registered(
            DeviceInfo info, Part.Registered part, Site site, double height, DeviceMount mount) {
        SimulatedKind kind =
                Objects.requireNonNull(KINDS.get(part.makes()), part.kind().key());
        var robot = new TrueRobot(
                world,
                site.body,
                mount,
                part.baseFromDevice(),
                height,
                seeds.stream(info.id()),
                settings.get(SimProvider.SENSOR_NOISE));
        SimulatedSensor<?> sensor = kind.create(info, part, robot);
        return sensor.rays() == 0
                ? new SimRegistered<>(sensor, part.period())
                : new SimRegisteredEye<>(sensor, part.period(), mount);
    }

    /// What keeps a model from being simulated, one sentence for each: its limits, and kinds of devices that
    /// are registered, but not for the simulator.
    static List<String> problems(RobotModel model) {
        return Stream.concat(
                        SimulationLimits.problems(model).stream(),
                        model.sensors().values().stream()
                                .filter(Part.Registered.class::isInstance)
                                .filter(part -> !KINDS.containsKey(part.makes()))
                                .map(part -> "The simulator has no device for '%s'.".formatted(part.name())))
                .toList();
    }

    private Duration watchdog() {
        return settings.seconds(SimProvider.WATCHDOG);
    }

    private NoisyRangeSensor.Noise noise(DeviceInfo info, RangeNoise noise) {
        return new NoisyRangeSensor.Noise(noise.times(settings.get(SimProvider.SENSOR_NOISE)), seeds.stream(info.id()));
    }

    private static DeviceInfo deviceOf(RobotSpec spec, String name) {
        return new DeviceInfo(spec.id(), name, SimProvider.KEY);
    }
}
