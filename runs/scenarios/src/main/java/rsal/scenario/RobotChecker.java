package rsal.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.device.RangeSensor;
import rsal.scenario.RobotReader.Role;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scene.Scene;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.time.LockstepScheduler;

/// Checks robots once all of them are known: markers, and what robot systems think of them.
final class RobotChecker {
    private final List<Role> roles;
    private final Location otherwise;
    private final Problems problems;

    /// @param otherwise where errors are of robots that have no role
    RobotChecker(List<Role> roles, Location otherwise, Problems problems) {
        this.roles = roles;
        this.otherwise = otherwise;
        this.problems = problems;
    }

    /// Finders of markers must not take one for another.
    void checkMarkers(List<PlannedThings> things, Location atThings) {
        var wearers = new HashMap<Integer, String>();
        for (Role role : roles) {
            for (PlannedRobot robot : role.robots()) {
                robot.spec()
                        .marker()
                        .ifPresent(marker -> note(
                                wearers,
                                marker,
                                robot.spec().id(),
                                role.placeOf(robot.spec().id(), Format.FIDUCIAL.name())));
            }
        }
        for (PlannedThings.PlannedThing thing :
                things.stream().flatMap(group -> group.each().stream()).toList()) {
            thing.thing()
                    .marker()
                    .ifPresent(
                            marker -> note(wearers, marker.id(), thing.thing().name(), atThings));
        }
    }

    private void note(Map<Integer, String> wearers, int marker, String name, Location at) {
        String other = wearers.putIfAbsent(marker, name);
        if (other != null) {
            problems.add(
                    at,
                    "'%s' and '%s' wear the same marker '%d'.".formatted(other, name, marker),
                    "Give 'fiducial' of one group another number, so that its ids don't meet the other's.");
        }
    }

    /// Lets the robot systems say what they think of their robots, of faults and things, without starting them.
    ///
    /// @param mrs the scenario's
    void checkRobots(
            Scene scene,
            Mrs mrs,
            List<PlannedRobot> robots,
            FaultReader faults,
            Location thingsAt,
            List<PlannedThings> things) {
        var simulated = new ArrayList<Mrs>();
        boolean refused = false;
        for (Mrs each : RunPlan.systems(mrs, robots)) {
            try (RobotSystem system = each.provider().create(each.config(scene, robots), new LockstepScheduler())) {
                faults.check(system, each);
                system.simulation().ifPresent(_ -> simulated.add(each));
            } catch (InvalidRobots e) {
                refused = true; // and may simulate or not
                for (InvalidRobots.Problem problem : e.problems()) {
                    problems.add(
                            placeOf(problem.robot(), problem.setting()),
                            "Robot '%s': %s".formatted(problem.robot(), problem.message()),
                            "");
                }
            }
        }
        if (!things.isEmpty() && simulated.isEmpty() && !refused) {
            problems.add(
                    thingsAt,
                    "%s simulates no world that 'things' could be put into.".formatted(mrs.name()),
                    "Remove 'things', or use robot system 'sim'.");
        }
        if (!refused) {
            checkMixed(robots, simulated);
        }
        simulated.stream().skip(1).forEach(other -> {
            String robot = other.own(robots).getFirst().id();
            problems.add(
                    placeOf(robot, SystemReader.KEY),
                    "Robot '%s' would be in another simulated world than those of %s; a run has one."
                            .formatted(robot, simulated.getFirst().words()),
                    "Give all simulated robots the same 'mrs'.");
        });
    }

    /// @param simulated systems
    private void checkMixed(List<PlannedRobot> robots, List<Mrs> simulated) {
        for (PlannedRobot robot : robots) {
            checkSeeing(robot, simulated);
            String id = robot.spec().id();
            Location at = placeOf(id, Format.PROXY.name());
            if (robot.proxy() && simulated.contains(robot.mrs())) {
                problems.add(at, "Robot '%s' is simulated itself and has no proxy.".formatted(id), "Remove 'proxy'.");
            } else if (robot.proxy() && simulated.isEmpty()) {
                problems.add(
                        at,
                        "There is no simulated world for a proxy of robot '%s'.".formatted(id),
                        "Remove 'proxy', or let the scenario use robot system 'sim'.");
            }
        }
    }

    private void checkSeeing(PlannedRobot robot, List<Mrs> simulated) {
        if (!robot.overlay()) {
            return;
        }
        String id = robot.spec().id();
        Location at = placeOf(id, Format.OVERLAY.name());
        if (simulated.contains(robot.mrs())) {
            problems.add(at, "Robot '%s' is simulated itself and sees its world.".formatted(id), "Remove 'overlay'.");
        } else if (simulated.isEmpty()) {
            problems.add(
                    at,
                    "There is no simulated world that robot '%s' could see.".formatted(id),
                    "Remove 'overlay', or let the scenario use robot system 'sim'.");
        } else if (!DeviceSelector.has(robot.spec().model(), RangeSensor.class)) {
            problems.add(
                    at,
                    "Robot '%s' has no laser and no sonars by which it could see what is simulated.".formatted(id),
                    "Add one to its 'devices', or remove 'overlay'.");
        }
    }

    private Location placeOf(String robot, String setting) {
        return roles.stream()
                .filter(role -> role.has(robot))
                .findFirst()
                .map(role -> role.placeOf(robot, setting))
                .orElse(otherwise);
    }
}
