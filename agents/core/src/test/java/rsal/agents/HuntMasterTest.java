package rsal.agents;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agent.message.Caught;
import rsal.agent.message.PoseReport;
import rsal.data.Pose2d;

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
    void theSecondOneCutsThePreyOffOnItsOtherSide() {
        hunter("a", 0);
        hunter("b", -5);
        master();
        prey("p", 20);
        scene.advance(4);
        prey("p", 20);
        scene.advance(1);
        assertThat(goal("a").x()).isEqualTo(20);
        assertThat(goal("b").x()).isEqualTo(23);
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
