package rsal.engine.world;

import java.time.Duration;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import rsal.behavior.Pilot;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Light;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.device.Sensor;
import rsal.device.SonarArray;
import rsal.engine.arbitration.Teleoperation;
import rsal.engine.communication.Faults;
import rsal.engine.report.DeviceView;
import rsal.engine.report.NavigatorState;
import rsal.engine.report.Reading;
import rsal.engine.report.RobotView;
import rsal.engine.report.Teammate;
import rsal.engine.robot.RobotTeam;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;

/// Shows robots as people see them, without what those that are gone or elsewhere now sensed and believed before.
/// All calls on the run's thread.
public final class RobotViews {
    private final RobotTeam team;
    private final SimulatedWorld world;
    private final Faults faults;
    private final Proxies proxies;
    private final InstantSource clock;

    public RobotViews(RobotTeam team, SimulatedWorld world, Faults faults, Proxies proxies, InstantSource clock) {
        this.team = team;
        this.world = world;
        this.faults = faults;
        this.proxies = proxies;
        this.clock = clock;
    }

    /// All that are there, in the order in which they came.
    public List<RobotView> all() {
        return team.mates().stream()
                .map(Teammate::spec)
                .flatMap(spec -> team.robot(spec.id()).map(robot -> view(spec, robot)).stream())
                .toList();
    }

    /// What its devices have told last, where it is now.
    public List<Reading> readings(Robot robot) {
        return readings(robot.id(), devices(robot, team.teleoperation(robot.id())));
    }

    private List<Reading> readings(String id, List<Device> devices) {
        if (faults.isGone(id) || world.lacks(id)) {
            return List.of();
        }
        return devices.stream()
                .flatMap(device -> reading(device).stream())
                .filter(reading -> world.placements().isOfHere(id, reading.value()))
                .toList();
    }

    /// What places cost its navigator, or the one that people send it by; empty when it has none that tells.
    public Optional<OccupancyGrid> costs(Robot robot) {
        Optional<Navigator> spare =
                team.teleoperation(robot.id()).flatMap(orders -> orders.outfit().find(Navigator.class));
        return robot.find(Navigator.class)
                .or(() -> spare)
                .filter(_ -> !faults.isGone(robot.id()))
                .flatMap(Navigator::costMap);
    }

    private Optional<Reading> reading(Device device) {
        return (switch (device) {
                    case Sensor<?> sensor -> sensor.latest();
                    case Navigator navigator -> Optional.of(state(navigator));
                    case Planner planner -> planner.latest();
                    default -> Optional.<Stamped<?>>empty();
                })
                .map(value -> new Reading(device.info().name(), value, age(value)));
    }

    /// As it is now: it tells of nothing by itself.
    private Stamped<NavigatorState> state(Navigator navigator) {
        var state = new NavigatorState(navigator.goal(), navigator.path().length(), navigator.paused());
        return new Stamped<>(clock.instant(), "map", state);
    }

    private RobotView view(RobotSpec spec, Robot robot) {
        String id = robot.id();
        Relocations placements = world.placements();
        boolean gone = faults.isGone(id);
        boolean there = !gone && !world.lacks(id);
        Optional<Teleoperation> reported = team.teleoperation(id);
        Optional<Localizer> localizer = team.localizer(robot).filter(_ -> there && placements.isBeliefOfHere(id));
        Optional<Navigator> navigator = reported.flatMap(
                        orders -> orders.outfit().find(Navigator.class))
                .filter(spare -> spare.goal().isPresent())
                .or(() -> robot.find(Navigator.class))
                .filter(_ -> there);
        List<Device> devices = devices(robot, reported);
        return new RobotView(
                id,
                robot.role(),
                spec.color(),
                robot.model().name(),
                gone,
                gone ? silence(robot) : Optional.empty(),
                world.truth(id),
                robot.find(DriveBase.class).filter(_ -> there).flatMap(DriveBase::latest),
                localizer.flatMap(Localizer::latest).filter(estimate -> placements.isOfHere(id, estimate)),
                localizer.flatMap(Localizer::particles).filter(cloud -> placements.isOfHere(id, cloud)),
                robot.find(LaserScanner.class)
                        .flatMap(LaserScanner::latest)
                        .filter(scan -> there && placements.isOfHere(id, scan)),
                robot.find(SonarArray.class)
                        .flatMap(SonarArray::latest)
                        .filter(ranges -> there && placements.isOfHere(id, ranges)),
                robot.find(Mapper.class).filter(_ -> there).flatMap(Mapper::latest),
                navigator.map(Navigator::path).orElse(Path2d.EMPTY),
                navigator
                        .filter(_ -> pilot(robot).isEmpty())
                        .map(Navigator::localPath)
                        .orElse(Path2d.EMPTY),
                navigator.flatMap(Navigator::goal),
                reported.map(Teleoperation::incharge)
                        .orElse(Optional.of(robot))
                        .filter(_ -> there)
                        .map(RobotViews::inCharge)
                        .orElse(""),
                reported.map(Teleoperation::behavior).orElse(""),
                reported.map(Teleoperation::driver).orElse(""),
                robot.find(Gripper.class).filter(_ -> there).flatMap(Gripper::latest),
                reported.filter(orders -> orders.arbiter().isOff()).isPresent(),
                reported.filter(orders -> orders.arbiter().isSwitchedOff()).isPresent(),
                robot.find(Light.class)
                        .filter(_ -> there)
                        .flatMap(Light::latest)
                        .filter(light -> light.value().lit())
                        .isPresent(),
                there ? world.carried(id) : List.of(),
                world.isSimulated(id) ? Optional.empty() : Optional.of(real(robot)),
                devices.stream().map(DeviceView::of).toList(),
                readings(id, devices));
    }

    private RobotView.Real real(Robot robot) {
        return new RobotView.Real(proxies.has(robot.id()), proxies.mapFromProxy(robot.id()), silence(robot));
    }

    /// For how long nobody has told where a robot is; empty when nobody ever has.
    private Optional<Duration> silence(Robot robot) {
        return teller(robot).flatMap(Sensor::latest).map(this::age);
    }

    private Duration age(Stamped<?> reading) {
        return Duration.between(reading.time(), clock.instant());
    }

    /// Who tells where a robot is.
    private Optional<? extends Sensor<?>> teller(Robot robot) {
        Optional<Localizer> localizer = team.localizer(robot);
        return localizer.isPresent() ? localizer : robot.find(DriveBase.class);
    }

    /// Its own, and those besides that are of another name.
    private static List<Device> devices(Robot robot, Optional<Teleoperation> reported) {
        var all = new LinkedHashMap<String, Device>();
        robot.devices().forEach(device -> all.put(device.info().name(), device));
        reported.ifPresent(orders ->
                orders.made().forEach(device -> all.putIfAbsent(device.info().name(), device)));
        return List.copyOf(all.values());
    }

    /// The one that commands the base, whatever goal the navigator still has; empty when none is engaged.
    private static Optional<Pilot> pilot(Robot robot) {
        return robot.find(Pilot.class).filter(Pilot::engaged);
    }

    private static String inCharge(Robot robot) {
        return pilot(robot)
                .flatMap(Pilot::latest)
                .map(decision -> decision.value().inCharge())
                .or(() -> robot.find(Navigator.class)
                        .filter(navigator -> navigator.goal().isPresent() && !navigator.paused())
                        .map(navigator -> navigator.info().name()))
                .orElse("");
    }
}
