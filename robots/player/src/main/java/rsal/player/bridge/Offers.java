package rsal.player.bridge;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
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
import rsal.time.Scheduler;

/// What of a robot is offered: each device under the interfaces that Player has for it, counted from 0 in its order.
final class Offers {
    private final Robot robot;
    private final Scheduler scheduler;
    private final Map<Interface, Integer> next = new EnumMap<>(Interface.class);
    private final List<Offered> offers = new ArrayList<>();
    private final Reins reins = new Reins();

    private Offers(Robot robot, Scheduler scheduler) {
        this.robot = robot;
        this.scheduler = scheduler;
    }

    static List<Offered> of(Robot robot, Scheduler scheduler) {
        var offers = new Offers(robot, scheduler);
        robot.devices().stream()
                .sorted(Comparator.comparing(SonarArray.class::isInstance)) // a laser is the first `ranger`
                .forEach(offers::add);
        return List.copyOf(offers.offers);
    }

    private int index(Interface interf) {
        return next.merge(interf, 1, Integer::sum) - 1;
    }

    private void add(Device device) {
        switch (device) {
            case DriveBase base ->
                offers.add(new OfferedBase(index(Interface.POSITION2D), base, robot.model(), reins, scheduler));
            case LaserScanner laser -> {
                offers.add(new OfferedLaser(Interface.RANGER, index(Interface.RANGER), laser, scheduler));
                offers.add(new OfferedLaser(Interface.LASER, index(Interface.LASER), laser, scheduler));
            }
            case SonarArray sonars -> {
                offers.add(new OfferedSonars(Interface.RANGER, index(Interface.RANGER), sonars, scheduler));
                offers.add(new OfferedSonars(Interface.SONAR, index(Interface.SONAR), sonars, scheduler));
            }
            case Battery battery -> offers.add(new OfferedBattery(index(Interface.POWER), battery, scheduler));
            case Bumper bumper -> offers.add(new OfferedBumpers(index(Interface.BUMPER), bumper, scheduler));
            case BlobFinder camera -> offers.add(new OfferedCamera(index(Interface.BLOBFINDER), camera, scheduler));
            case FiducialFinder finder -> offers.add(new OfferedMarkers(index(Interface.FIDUCIAL), finder, scheduler));
            case Gripper gripper -> addGripper(gripper);
            case Actuator actuator -> offers.add(new OfferedActuator(index(Interface.ACTARRAY), actuator, scheduler));
            case Localizer localizer ->
                offers.add(new OfferedLocalizer(index(Interface.LOCALIZE), localizer, scheduler));
            case Navigator navigator ->
                offers.add(new OfferedNavigator(
                        index(Interface.PLANNER),
                        navigator,
                        robot.find(Localizer.class),
                        Tolerance.DEFAULT,
                        reins,
                        scheduler));
            default -> {} // Player has nothing like it
        }
    }

    private void addGripper(Gripper gripper) {
        var jaws = new Jaws(gripper);
        offers.add(new OfferedGripper(index(Interface.GRIPPER), gripper, jaws, scheduler));
        offers.add(new OfferedBeams(index(Interface.DIO), gripper, scheduler));
        Part part = robot.model().sensors().get(gripper.info().name());
        if (part instanceof Part.Gripper made && made.hasLift()) {
            offers.add(new OfferedLift(index(Interface.ACTARRAY), gripper, jaws, scheduler));
        }
    }
}
