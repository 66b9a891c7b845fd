package rsal.sim;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/// The robots that are in the world now, and those that are away for a while. Lists are never changed but
/// replaced, so that robots may come and go while somebody goes through one.
final class SimulatedRobots {
    private final TreeMap<String, SimRobot> byId = new TreeMap<>();
    private final Set<String> away = new HashSet<>();
    private List<SimRobot> all = List.of();
    private List<SimRobot> robots = List.of();
    private List<SimRobot> workers = List.of();
    private List<SimGripper> grippers = List.of();
    private List<SimBattery> batteries = List.of();
    private int changes;

    SimulatedRobots(List<SimRobot> robots) {
        robots.forEach(robot -> byId.put(robot.id(), robot));
        list();
    }

    void add(SimRobot robot) {
        byId.put(robot.id(), robot);
        list();
    }

    void remove(SimRobot robot) {
        byId.remove(robot.id());
        away.remove(robot.id());
        list();
    }

    /// It is not among the robots any more, but its id stays its own.
    void leave(SimRobot robot) {
        away.add(robot.id());
        list();
    }

    void comeBack(SimRobot robot) {
        away.remove(robot.id());
        list();
    }

    boolean isAway(SimRobot robot) {
        return away.contains(robot.id()) && isKnown(robot);
    }

    private void list() {
        changes++;
        all = List.copyOf(byId.values());
        robots = all.stream().filter(robot -> !away.contains(robot.id())).toList();
        workers = robots.stream().filter(robot -> !robot.parts().isEmpty()).toList();
        grippers = devices(all, SimGripper.class);
        batteries = devices(robots, SimBattery.class);
    }

    private static <D> List<D> devices(List<SimRobot> robots, Class<D> type) {
        return robots.stream()
                .flatMap(robot -> robot.parts().stream())
                .filter(type::isInstance)
                .map(type::cast)
                .toList();
    }

    /// Those that are not away, in the order of their ids.
    List<SimRobot> robots() {
        return robots;
    }

    /// Those of them that carry something that feels or moves, in the order of their ids.
    List<SimRobot> workers() {
        return workers;
    }

    /// Those that are away, too, in the order of their ids.
    List<SimRobot> all() {
        return all;
    }

    /// How often robots came or went; when it has not grown, all are still there.
    int changes() {
        return changes;
    }

    /// Also finds one that is away.
    Optional<SimRobot> find(String id) {
        return Optional.ofNullable(byId.get(id));
    }

    /// Whether a robot out of an earlier list is still there.
    boolean has(SimRobot robot) {
        return !away.contains(robot.id()) && isKnown(robot);
    }

    private boolean isKnown(SimRobot robot) {
        SimRobot now = byId.get(robot.id());
        return now != null && now.body().equals(robot.body());
    }

    /// Of all robots, those too that are away, in the order of their ids.
    List<SimGripper> grippers() {
        return grippers;
    }

    /// Of robots that are not away, in the order of their ids.
    List<SimBattery> batteries() {
        return batteries;
    }
}
