package rsal.player.bridge;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.device.Actuator;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.FiducialFinder;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.device.SonarArray;
import rsal.player.message.Interface;
import rsal.robot.Robot;
import rsal.robot.RobotModel.Part;
import rsal.system.CommandTimeout;
import rsal.time.Scheduler;

/// What of a robot is offered: its devices under the interfaces that Player has for them.
final class Offers {
    private final Robot robot;
    private final CommandTimeout timeout;
    private final Scheduler scheduler;
    private final ExclusiveControl control = new ExclusiveControl();
    private final Map<Gripper, GripperCommands> commands = new HashMap<>();

    /// @param timeout of what is said again and again
    Offers(Robot robot, CommandTimeout timeout, Scheduler scheduler) {
        this.robot = robot;
        this.timeout = timeout;
        this.scheduler = scheduler;
    }

    /// Each device under each interface, counted from 0 in its order.
    List<Offered> all() {
        var next = new EnumMap<Interface, Integer>(Interface.class);
        var offers = new ArrayList<Offered>();
        List<Device> devices = robot.devices().stream()
                .sorted(Comparator.comparing(SonarArray.class::isInstance)) // a laser is the first `ranger`
                .toList();
        for (Device device : devices) {
            for (Interface as : interfaces(device)) {
                int index = next.merge(as, 1, Integer::sum) - 1;
                offer(as, index, device, Tolerance.DEFAULT).ifPresent(offers::add);
            }
        }
        return List.copyOf(offers);
    }

    private List<Interface> interfaces(Device device) {
        return switch (device) {
            case DriveBase _ -> List.of(Interface.POSITION2D);
            case LaserScanner _ -> List.of(Interface.RANGER, Interface.LASER);
            case SonarArray _ -> List.of(Interface.RANGER, Interface.SONAR);
            case Battery _ -> List.of(Interface.POWER);
            case Bumper _ -> List.of(Interface.BUMPER);
            case BlobFinder _ -> List.of(Interface.BLOBFINDER);
            case FiducialFinder _ -> List.of(Interface.FIDUCIAL);
            case Gripper gripper when hasLift(gripper) -> List.of(Interface.GRIPPER, Interface.DIO, Interface.ACTARRAY);
            case Gripper _ -> List.of(Interface.GRIPPER, Interface.DIO);
            case Actuator _ -> List.of(Interface.ACTARRAY);
            case Localizer _ -> List.of(Interface.LOCALIZE);
            case Navigator _ -> List.of(Interface.PLANNER);
            default -> List.of(); // Player has nothing like it
        };
    }

    private boolean hasLift(Gripper gripper) {
        return part(gripper, Part.Gripper.class).filter(Part.Gripper::hasLift).isPresent();
    }

    /// What a device is made like; empty when its robot's model does not say.
    private <P extends Part> Optional<P> part(Device device, Class<P> type) {
        return Optional.ofNullable(robot.model().sensors().get(device.info().name()))
                .filter(type::isInstance)
                .map(type::cast);
    }

    /// A device by its name under one interface; empty when there is none, or it is nothing like that.
    ///
    /// @param tolerance when the robot is near enough to where clients send it
    Optional<Offered> offer(Interface as, int index, String device, Tolerance tolerance) {
        return robot.devices().stream()
                .filter(own -> own.info().name().equals(device))
                .findFirst()
                .flatMap(own -> offer(as, index, own, tolerance));
    }

    private Optional<Offered> offer(Interface as, int index, Device device, Tolerance tolerance) {
        return Optional.ofNullable(
                switch (device) {
                    case DriveBase base
                    when as == Interface.POSITION2D ->
                        new OfferedBase(index, base, robot.model(), Optional.empty(), control, timeout, scheduler);
                    case LaserScanner laser
                    when as == Interface.RANGER || as == Interface.LASER ->
                        new OfferedLaser(as, index, laser, scheduler);
                    case SonarArray sonars
                    when as == Interface.RANGER || as == Interface.SONAR ->
                        new OfferedSonars(as, index, sonars, scheduler);
                    case Battery battery when as == Interface.POWER -> new OfferedBattery(index, battery, scheduler);
                    case Bumper bumper
                    when as == Interface.BUMPER -> new OfferedBumpers(index, bumper, pads(bumper), scheduler);
                    case BlobFinder camera
                    when as == Interface.BLOBFINDER -> new OfferedCamera(index, camera, scheduler);
                    case FiducialFinder finder
                    when as == Interface.FIDUCIAL -> new OfferedMarkers(index, finder, scheduler);
                    case Gripper gripper
                    when as == Interface.GRIPPER ->
                        new OfferedGripper(
                                index, gripper, commands(gripper), part(gripper, Part.Gripper.class), scheduler);
                    case Gripper gripper when as == Interface.DIO -> new OfferedBeams(index, gripper, scheduler);
                    case Gripper gripper
                    when as == Interface.ACTARRAY -> new OfferedLift(index, gripper, commands(gripper), scheduler);
                    case Actuator actuator
                    when as == Interface.ACTARRAY -> new OfferedActuator(index, actuator, timeout, scheduler);
                    case Localizer localizer
                    when as == Interface.LOCALIZE -> new OfferedLocalizer(index, localizer, scheduler);
                    case Localizer localizer
                    when as == Interface.POSITION2D -> new OfferedPose(index, localizer, robot, scheduler);
                    case Navigator navigator
                    when as == Interface.PLANNER ->
                        new OfferedNavigator(
                                index, navigator, robot.find(Localizer.class), tolerance, control, scheduler);
                    case Navigator navigator
                    when as == Interface.POSITION2D ->
                        new OfferedBase(
                                index,
                                robot.require(DriveBase.class),
                                robot.model(),
                                Optional.of(guide(navigator, tolerance)),
                                control,
                                timeout,
                                scheduler);
                    default -> null;
                });
    }

    private Guide guide(Navigator navigator, Tolerance tolerance) {
        return new Guide(robot.require(DriveBase.class), navigator, robot.require(Localizer.class), tolerance);
    }

    private List<Part.Bumper.Pad> pads(Bumper bumper) {
        return part(bumper, Part.Bumper.class).map(Part.Bumper::pads).orElse(List.of());
    }

    private GripperCommands commands(Gripper gripper) {
        return commands.computeIfAbsent(gripper, GripperCommands::new);
    }
}
