package rsal.agents.pursuit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agent.message.PoseReport;
import rsal.agents.FakePlanner;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.PlaceFinder;

/// Agents of type `hunt` and `follow` with bids together.
class HuntMasterTest {
    private final Scene scene = new Scene();
    private final Map<String, FakeRobot> hunters = new TreeMap<>();

    private void hunter(String id, double x) {
        FakeRobot robot = scene.robot(id, "hunter");
        hunters.put(id, robot);
        scene.start("follow", robot, Map.of("assignment", "bids", "updateInterval", 1));
        robot.isAt(x, 0);
        scene.report(id, "hunter", x, 0);
    }

    /// Knows ways and where prey may run to.
    private void cleverHunter(String id, double x, double y) {
        FakeRobot robot = scene.robot(id, "hunter");
        hunters.put(id, robot);
        robot.places.result = new PlaceFinder.Result.Found(List.of(new Point2d(30, 0), new Point2d(10, -30)));
        scene.start(
                "follow",
                id,
                Optional.of(robot.robot.with(robot.places).with(new FakePlanner(id))),
                Map.of("assignment", "bids", "updateInterval", 1));
        robot.isAt(x, y);
        scene.report(id, "hunter", x, y);
    }

    private void master() {
        scene.start("hunt", "master", Optional.empty(), Map.of("interval", 4));
    }

    private void prey(String id, double x) {
        scene.report(id, "prey", x, 0);
    }

    private Pose2d goal(String id) {
        return hunters.get(id).navigator.goals.getLast();
    }

    @Test
    void eachPreyGoesToTheHunterThatMakesAllWaysShort() {
        hunter("a", 0);
        hunter("b", 100);
        master();
        prey("p1", 90);
        prey("p2", 40);
        scene.advance(4);
        assertThat(goal("a").x()).isEqualTo(40);
        assertThat(goal("b").x()).isEqualTo(90);
        assertThat(scene.state("a")).isEqualTo("hunt p2");
        assertThat(scene.state("master")).isEqualTo("hunting p1, p2");
    }

    @Test
    void allThatAreFreeGoForThePreyThatIsLeft() {
        hunter("a", 0);
        hunter("b", -5);
        hunter("c", 70);
        master();
        prey("p", 20);
        scene.advance(1);
        assertThat(scene.state("a")).isEqualTo("hunt p");
        assertThat(scene.state("b")).isEqualTo("hunt p as no. 2");
        assertThat(scene.state("c")).isEqualTo("hunt p as no. 3");
        assertThat(goal("c").x()).isEqualTo(20);
    }

    /// It would run from a, which is near, to (30, 0) or (10, -30); there it has the greater lead.
    @Test
    void oneThatIsAsideMeetsThePreyOnTheWayThatItWouldTake() {
        cleverHunter("a", 4, 0);
        cleverHunter("b", 18, 8);
        master();
        prey("p", 10);
        scene.advance(1);
        prey("p", 10);
        scene.advance(1);
        assertThat(goal("b")).isEqualTo(new Pose2d(16, 0, 0)); // 8.2 m for it, and 6 m for the prey
        assertThat(goal("a").y()).isZero();
    }

    @Test
    void whereThePreyIsFarFromAllTheyGoWhereItIs() {
        cleverHunter("a", 4, 0);
        cleverHunter("b", 18, 8);
        master();
        prey("p", 40);
        scene.advance(1);
        assertThat(goal("a").x()).isEqualTo(40);
        assertThat(goal("b").x()).isEqualTo(40);
    }

    @Test
    void theyChangeOverWhenAnotherHasComeMuchNearer() {
        hunter("a", 0);
        hunter("b", 100);
        master();
        for (double x = 20; x <= 80; x += 20) {
            prey("p1", x);
            prey("p2", 100 - x);
            scene.advance(4);
        }
        assertThat(scene.state("a")).isEqualTo("hunt p2");
        assertThat(scene.state("b")).isEqualTo("hunt p1");
    }

    @Test
    void stopsNearItsPreyAndGoesForAnotherWhenItIsCaught() {
        hunter("a", 0);
        master();
        prey("p1", 10);
        prey("p2", 50);
        scene.advance(1);
        hunters.get("a").isAt(9, 0);
        prey("p1", 10);
        assertThat(hunters.get("a").navigator.driving()).isFalse();
        scene.hear("p1", Caught.TOPIC, new Caught("p1", "a", 1));
        prey("p1", 10);
        scene.advance(0);
        assertThat(goal("a").x()).isEqualTo(50);
        scene.hear("p2", Caught.TOPIC, new Caught("p2", "a", 1));
        assertThat(scene.state("master")).isEqualTo("all that were seen are caught");
        assertThat(hunters.get("a").navigator.driving()).isFalse();
    }

    @Test
    void preyThatIsHeardOfNoMoreIsLeftUntilItIs() {
        hunter("a", 0);
        master();
        prey("p", 10);
        scene.advance(30);
        assertThat(hunters.get("a").navigator.driving()).isFalse();
        scene.report("p", "prey", 20, 0);
        scene.advance(100); // one that failed waits for a minute
        scene.hear("radio", PoseReport.TOPIC, new PoseReport("p", "prey", new Pose2d(25, 0, 0)));
        scene.advance(6);
        assertThat(goal("a").x()).isEqualTo(25);
    }
}
