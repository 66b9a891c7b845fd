package rsal.agents.patrol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agents.FakeBattery;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.BatteryState.Charging;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.PlaceFinder;

/// Agents of types `patrol` and `worker` together.
class PatrolTest {
    private final Scene scene = new Scene();
    private final Map<String, FakeRobot> robots = new TreeMap<>();
    private final Map<String, FakeBattery> batteries = new TreeMap<>();

    private FakeRobot guard(String id, double x) {
        FakeRobot robot = scene.robot(id, "guard");
        var battery = new FakeBattery(id);
        robots.put(id, robot);
        batteries.put(id, battery);
        var equipped = robot.robot.with(battery).with(robot.places);
        scene.start("worker", id, Optional.of(equipped), Map.of("chargers", "50 0; 90 0"));
        robot.isAt(x, 0);
        return robot;
    }

    private void patrol(Map<String, ?> arguments) {
        scene.start("patrol", "patrol", Optional.empty(), arguments);
        scene.advance(0);
    }

    private void charge(String id, double level, Charging charging) {
        batteries.get(id).is(level, charging, scene.scheduler.instant());
        scene.advance(0);
    }

    private double goal(String id) {
        return robots.get(id).navigator.goals.getLast().x();
    }

    private void reach(String id) {
        FakeRobot robot = robots.get(id);
        Pose2d goal = robot.navigator.goals.getLast();
        robot.isAt(goal.x(), goal.y());
        robot.navigator.reach();
        scene.advance(0);
    }

    @Test
    void eachPlaceGoesToTheOneThatIsNearAndThenToWhereNobodyWasForLong() {
        guard("a", 0);
        guard("b", 20);
        patrol(Map.of("places", "1 0; 3 0; 18 0", "urgency", 1));
        assertThat(goal("a")).isEqualTo(1);
        assertThat(goal("b")).isEqualTo(18);
        scene.advance(10);
        reach("a");
        assertThat(goal("a")).as("not the one where it is").isEqualTo(3);
        assertThat(scene.said("patrol", Watch.TOPIC)).hasSize(1);
        assertThat(scene.said("patrol", Visited.TOPIC)).containsExactly(new Visited("a", new Point2d(1, 0)));
        assertThat(scene.state("patrol")).isEqualTo("watching 3 places, left alone for 7 s, at most 10 s");
    }

    @Test
    void alongACycleTheyBeginEvenlySpacedAndLeaveOutWhereTheyCannotGet() {
        guard("a", 0);
        guard("b", 0);
        scene.advance(1);
        patrol(Map.of("places", "1 0; 2 0; 3 0; 4 0", "strategy", "cycle"));
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(1);
        assertThat(goal("b")).isEqualTo(3);
        reach("a");
        assertThat(goal("a")).isEqualTo(2);
        robots.get("a").navigator.end(new Result.NoPath("A wall."));
        scene.advance(0);
        assertThat(goal("a")).isEqualTo(3);
        reach("b");
        reach("b");
        assertThat(goal("b")).isEqualTo(1);
    }

    @Test
    void atRandomTheyGoAnywhere() {
        guard("a", 0);
        patrol(Map.of("places", "1 0; 2 0; 3 0; 4 0", "strategy", "random"));
        scene.advance(6);
        for (int i = 0; i < 40; i++) {
            reach("a");
        }
        assertThat(robots.get("a").navigator.goals.stream().map(Pose2d::x)).contains(1.0, 2.0, 3.0, 4.0);
    }

    @Test
    void placesAreFoundWhenNoneAreGiven() {
        guard("a", 0).places.result = new PlaceFinder.Result.Found(List.of(new Point2d(7, 0), new Point2d(8, 0)));
        patrol(Map.of("places", "", "count", 2));
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(7);
    }

    @Test
    void guardWhoseBatteryIsLowChargesWhileAnotherTakesItsPlace() {
        guard("a", 0);
        patrol(Map.of("places", "1 0"));
        guard("b", 20);
        charge("a", 0.2, Charging.DISCHARGING);
        assertThat(goal("a")).as("the nearest charger").isEqualTo(50);
        assertThat(goal("b")).isEqualTo(1);
        reach("a");
        charge("a", 0.2, Charging.DISCHARGING);
        scene.advance(6);
        assertThat(goal("a")).as("the next, as nothing comes of the first").isEqualTo(90);
        reach("a");
        charge("a", 0.5, Charging.CHARGING);
        scene.advance(60);
        assertThat(scene.state("a")).isEqualTo("charging at (90.0, 0.0)");
        charge("a", 0.95, Charging.CHARGING);
        robots.get("b").navigator.end(new Result.NoPath("A wall."));
        scene.advance(1);
        assertThat(goal("a")).isEqualTo(1);
    }

    @Test
    void guardsAreChargedWhereNobodyElseIs() {
        guard("a", 40);
        guard("b", 45);
        patrol(Map.of("places", "1 0"));
        charge("b", 0.2, Charging.DISCHARGING);
        assertThat(goal("b")).isEqualTo(50);
        scene.advance(60);
        charge("a", 0.2, Charging.DISCHARGING);
        assertThat(goal("a")).isEqualTo(90);
    }

    @Test
    void guardThatIsSentAwayFromItsChargerGoesBackAndTakesNoJobs() {
        guard("a", 40);
        patrol(Map.of("places", "1 0"));
        charge("a", 0.2, Charging.DISCHARGING);
        scene.order("a", 5, 0);
        assertThat(goal("a")).isEqualTo(5);
        reach("a");
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(50);
        charge("a", 0.95, Charging.CHARGING);
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(1);
    }

    @Test
    void errandsComeFirst() {
        guard("a", 0);
        patrol(Map.of("places", "1 0"));
        scene.order("a", 5, 0);
        assertThat(goal("a")).isEqualTo(5);
        scene.advance(10);
        assertThat(goal("a")).isEqualTo(5);
        reach("a");
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(1);
    }
}
