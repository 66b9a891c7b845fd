package rsal.sim;

import java.util.List;
import java.util.Optional;
import java.util.TreeMap;

/// The robots that are in the world now. Lists are never changed but replaced, so that robots may come and go while
/// somebody goes through one.
final class Team {
    private final TreeMap<String, SimRobot> byId = new TreeMap<>();
    private List<SimRobot> robots = List.of();
    private List<SimGripper> grippers = List.of();
    private List<SimBattery> batteries = List.of();
    private int changes;

    Team(List<SimRobot> robots) {
        robots.forEach(robot -> byId.put(robot.id(), robot));
        list();
    }

    void add(SimRobot robot) {
        byId.put(robot.id(), robot);
        list();
    }

    void remove(SimRobot robot) {
        byId.remove(robot.id());
        list();
    }

    private void list() {
        changes++;
        robots = List.copyOf(byId.values());
        grippers = devices(SimGripper.class);
        batteries = devices(SimBattery.class);
    }

    private <D> List<D> devices(Class<D> type) {
        return robots.stream()
                .flatMap(robot -> robot.parts().stream())
                .filter(type::isInstance)
                .map(type::cast)
                .toList();
    }

    /// In the order of their ids.
    List<SimRobot> robots() {
        return robots;
    }

    /// How often robots came or went; when it has not grown, all are still there.
    int changes() {
        return changes;
    }

    Optional<SimRobot> find(String id) {
        return Optional.ofNullable(byId.get(id));
    }

    /// Whether a robot out of an earlier list is still there.
    boolean has(SimRobot robot) {
        SimRobot now = byId.get(robot.id());
        return now != null && now.body().equals(robot.body());
    }

    /// Of all robots, in the order of their ids.
    List<SimGripper> grippers() {
        return grippers;
    }

    /// Of all robots, in the order of their ids.
    List<SimBattery> batteries() {
        return batteries;
    }
}
