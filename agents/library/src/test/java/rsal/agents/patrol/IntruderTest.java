package rsal.agents.patrol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agent.message.PoseReport;
import rsal.agents.FakeCamera;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.agents.pursuit.Caught;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;

/// Agents of types `patrol`, `worker` and `intrude` when somebody is there who should not be.
class IntruderTest {
    private static final Rgb RED = Rgb.of(0xd55e00);

    private final Scene scene = new Scene();
    private final Map<String, FakeRobot> robots = new TreeMap<>();
    private final Map<String, FakeCamera> cameras = new TreeMap<>();

    private void guard(String id, double x) {
        FakeRobot robot = scene.robot(id, "guard");
        var camera = new FakeCamera(id);
        robots.put(id, robot);
        cameras.put(id, camera);
        scene.start("worker", id, Optional.of(robot.robot.with(camera)), Map.of("intruder", "#d55e00"));
        robot.isAt(x, 0);
    }

    /// Four of them, on their way to places far from each other.
    private void patrol(Map<String, ?> arguments) {
        guard("a", 0);
        guard("b", 20);
        guard("c", 40);
        guard("d", 60);
        var all = new TreeMap<String, Object>(Map.of("places", "0 9; 20 9; 40 9; 60 9"));
        all.putAll(arguments);
        scene.start("patrol", "patrol", Optional.empty(), all);
        scene.advance(6);
        assertThat(goals())
                .containsExactly(new Point2d(0, 9), new Point2d(20, 9), new Point2d(40, 9), new Point2d(60, 9));
    }

    private List<Point2d> goals() {
        return robots.values().stream()
                .map(robot -> robot.navigator.goals.getLast().position())
                .toList();
    }

    private void see(String id, double range) {
        cameras.get(id).show(RED, range);
        scene.advance(0);
    }

    @Test
    void theNearestTwoGoThereAndTheOthersGoOn() {
        patrol(Map.of());
        see("b", 5);
        assertThat(scene.said("b", Alarm.TOPIC)).containsExactly(new Alarm("b", new Point2d(25, 0)));
        assertThat(goals())
                .as("the one that sees it stops in front of it")
                .containsExactly(new Point2d(0, 9), new Point2d(24, 0), new Point2d(25, 0), new Point2d(60, 9));
        assertThat(scene.state("patrol")).startsWith("alarm 1, watching 4 places");
    }

    @Test
    void theyFollowItAndGoBackToTheirPlacesWhenOneHasMetIt() {
        patrol(Map.of());
        see("b", 5);
        scene.advance(1);
        see("b", 7);
        scene.advance(1);
        assertThat(goals()).contains(new Point2d(26, 0), new Point2d(27, 0));
        robots.get("b").isAt(25.5, 0);
        for (int i = 0; i < 12; i++) {
            see("b", 1.5);
            scene.advance(1);
        }
        assertThat(scene.state("patrol")).startsWith("watching");
        assertThat(goals())
                .containsExactly(new Point2d(0, 9), new Point2d(20, 9), new Point2d(40, 9), new Point2d(60, 9));
        see("b", 1.5);
        scene.advance(5);
        assertThat(scene.state("patrol")).as("it is where it was met").startsWith("watching");
        see("b", 8);
        scene.advance(5);
        assertThat(scene.state("patrol")).as("it got away").startsWith("alarm 2");
    }

    @Test
    void anIntruderThatNobodySeesIsLookedForAndThenForgotten() {
        patrol(Map.of());
        see("b", 5);
        robots.get("b").isAt(24, 0);
        robots.get("b").navigator.reach();
        scene.advance(15);
        assertThat(scene.state("patrol")).startsWith("alarm 1");
        scene.advance(10);
        assertThat(scene.state("patrol")).startsWith("watching");
        assertThat(goals()).contains(new Point2d(20, 9), new Point2d(40, 9));
    }

    @Test
    void someoneNearTheLastPlaceTurnsToIt() {
        patrol(Map.of());
        see("b", 5);
        robots.get("b").isAt(25, -1);
        scene.advance(3);
        Pose2d goal = robots.get("b").navigator.goals.getLast();
        assertThat(goal).isEqualTo(new Pose2d(25, -1, Math.PI / 2));
    }

    @Test
    void whereverTheyGoByOtherWaysTheyAreCalledToo() {
        patrol(Map.of("strategy", "partition", "responders", 1));
        see("c", 5);
        assertThat(goals())
                .containsExactly(new Point2d(0, 9), new Point2d(20, 9), new Point2d(44, 0), new Point2d(60, 9));
        scene.advance(30);
        assertThat(goals())
                .containsExactly(new Point2d(0, 9), new Point2d(20, 9), new Point2d(40, 9), new Point2d(60, 9));
    }

    @Test
    void nobodyIsCalledWhenNobodyIsTo() {
        patrol(Map.of("responders", 0));
        see("b", 5);
        assertThat(goals()).contains(new Point2d(20, 9));
    }

    @Test
    void otherColorsAreNoIntruders() {
        patrol(Map.of());
        cameras.get("b").show(FakeCamera.GREEN, 5);
        scene.advance(0);
        assertThat(scene.said("b", Alarm.TOPIC)).isEmpty();
    }

    @Test
    void anIntruderSaysNothingUntilOneOfThoseThatWatchIsNear() {
        FakeRobot robot = scene.robot("thief", "thief");
        scene.start("intrude", robot, Map.of("hunter", "guard", "catchDistance", 1.5));
        robot.isAt(0, 0);
        scene.advance(5);
        scene.report("other", "other", 1, 0);
        scene.report("a", "guard", 2, 0);
        assertThat(scene.said("thief", PoseReport.TOPIC)).isEmpty();
        assertThat(scene.said("thief", Caught.TOPIC)).isEmpty();
        scene.report("a", "guard", 1, 0);
        assertThat(scene.said("thief", Caught.TOPIC)).containsExactly(new Caught("thief", "a", 1));
    }
}
