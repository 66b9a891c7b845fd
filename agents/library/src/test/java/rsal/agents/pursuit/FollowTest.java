package rsal.agents.pursuit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.agent.message.GoalReached;
import rsal.agent.message.PoseReport;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;

class FollowTest {
    private static final Map<String, ?> NEAREST = Map.of("assignment", "nearest");

    private final Scene scene = new Scene();
    private final FakeRobot h1 = scene.robot("h1", "hunter");

    @Test
    void goesForAPreyAtOnceAndThenForItsNewestPoseEachInterval() {
        hunterAt(h1, 0, Map.of("updateInterval", 2.0));
        scene.report("p1", "prey", 10, 0);
        assertThat(h1.navigator.goals).containsExactly(at(10));

        scene.advance(1.9);
        scene.report("p1", "prey", 11, 0);
        assertThat(h1.navigator.goals).hasSize(1);
        scene.advance(0.1);
        assertThat(h1.navigator.goals).containsExactly(at(10), at(11));
        assertThat(scene.state("h1")).isEqualTo("hunting p1");
    }

    @Test
    void keepsItsPlanWhileThePreyStands() {
        hunterAt(h1, 0, Map.of());
        for (int i = 0; i < 5; i++) {
            scene.report("p1", "prey", 10, 0);
            scene.advance(2);
        }
        assertThat(h1.navigator.goals).containsExactly(at(10));
    }

    @Test
    void huntsOnlyItsPrey() {
        hunterAt(h1, 0, Map.of("prey", "p2"));
        scene.report("p1", "prey", 10, 0);
        scene.report("h2", "hunter", 10, 0);
        assertThat(h1.navigator.goals).isEmpty();
        scene.report("p2", "prey", 20, 0);
        assertThat(h1.navigator.goals).containsExactly(at(20));
    }

    @Test
    void stopsNearThePreyAndKeepsReportingUntilItGivesUp() {
        hunterAt(h1, 0, Map.of("catchDistance", 2.0));
        scene.report("p1", "prey", 10, 0);
        move(h1, 8.0);
        assertThat(h1.navigator.driving()).isTrue(); // 2 m is not nearer than 2 m
        move(h1, 8.1);
        assertThat(h1.navigator.driving()).isFalse();
        assertThat(scene.state("h1")).isEqualTo("holding p1 at bay");

        int before = scene.said("h1", PoseReport.TOPIC).size();
        move(h1, 8.1);
        assertThat(scene.said("h1", PoseReport.TOPIC)).hasSize(before + 1);
        assertThat(h1.navigator.goals).hasSize(1);

        scene.hear("p1", Caught.TOPIC, new Caught("p1", "h1", 1.9));
        scene.report("p1", "prey", 12, 0);
        scene.advance(10);
        assertThat(h1.navigator.goals).hasSize(1);
        assertThat(scene.state("h1")).isEqualTo("looking for more prey");
    }

    @Test
    void huntsOnWhenThePreySlipsAway() {
        hunterAt(h1, 9, Map.of());
        scene.report("p1", "prey", 10, 0);
        assertThat(h1.navigator.goals).isEmpty();
        scene.report("p1", "prey", 14, 0);
        scene.advance(2);
        assertThat(h1.navigator.goals).containsExactly(at(14));
    }

    @Test
    void triesAgainWithTheNewestPoseWhenItIsStuckOrThereIsNoWay() {
        hunterAt(h1, 0, Map.of());
        scene.report("p1", "prey", 10, 0);
        h1.navigator.end(new Result.NoPath("a wall"));
        scene.advance(2);
        assertThat(h1.navigator.goals).containsExactly(at(10), at(10));
        h1.navigator.end(FakeRobot.stuck());
        scene.report("p1", "prey", 10.05, 0);
        scene.advance(2);
        assertThat(h1.navigator.goals).containsExactly(at(10), at(10), at(10.05));
    }

    @Test
    void goesOnAtOnceWhenThePreyHasGoneOnMeanwhile() {
        hunterAt(h1, 0, Map.of("updateInterval", 60));
        scene.report("p1", "prey", 10, 0);
        scene.report("p1", "prey", 13, 0);
        h1.navigator.reach();
        scene.advance(0);
        assertThat(h1.navigator.goals).containsExactly(at(10), at(13));
    }

    @Test
    void forgetsAPreyNotHeardOfForLong() {
        hunterAt(h1, 0, Map.of());
        scene.report("p1", "prey", 10, 0);
        scene.advance(9);
        assertThat(h1.navigator.driving()).isTrue();
        scene.advance(3);
        assertThat(h1.navigator.driving()).isFalse();
        assertThat(scene.state("h1")).isEqualTo("looking for prey");
    }

    @Test
    void ordersComeBeforeTheHunt() {
        hunterAt(h1, 0, Map.of());
        scene.report("p1", "prey", 10, 0);
        scene.order("h1", -5, 0);
        scene.report("p1", "prey", 11, 0);
        scene.advance(4);
        assertThat(h1.navigator.goals).containsExactly(at(10), at(-5));

        move(h1, 10); // near the prey: an order is an order
        assertThat(h1.navigator.driving()).isTrue();
        move(h1, -5);
        h1.navigator.reach();
        scene.advance(0);
        assertThat(h1.navigator.goals).containsExactly(at(10), at(-5), at(11));
        assertThat(scene.said("h1", GoalReached.TOPIC)).containsExactly(new GoalReached("h1", at(-5), "reached", ""));
        assertThat(scene.state("h1")).isEqualTo("hunting p1");
    }

    @Test
    void fixedHuntersTakePreyInTurnAndTheNextWhenTheirsIsCaught() {
        FakeRobot h2 = scene.robot("h2", "hunter");
        hunterAt(h1, 0, Map.of());
        hunterAt(h2, 0, Map.of());
        scene.report("p1", "prey", 10, 0);
        scene.report("p2", "prey", 20, 0);
        assertThat(h1.navigator.goals.getLast()).isEqualTo(at(10));
        assertThat(h2.navigator.goals.getLast()).isEqualTo(at(20));

        scene.hear("p2", Caught.TOPIC, new Caught("p2", "h2", 1.9));
        assertThat(h2.navigator.goals.getLast()).isEqualTo(at(10));
        assertThat(h1.navigator.goals).hasSize(1);
    }

    @Test
    void fixedHuntersKeepTheirPreyWhenAnotherFallsSilent() {
        FakeRobot h2 = scene.robot("h2", "hunter");
        hunterAt(h1, 0, Map.of());
        hunterAt(h2, 0, Map.of());
        scene.report("p1", "prey", 10, 0);
        for (int i = 0; i < 10; i++) {
            scene.report("p2", "prey", 20, 0);
            scene.report("p3", "prey", 30, 0);
            scene.advance(2);
        }
        assertThat(h2.navigator.goals.getLast()).isEqualTo(at(20));
        assertThat(h1.navigator.goals.getLast()).isEqualTo(at(20)); // helps, as its own is gone
    }

    @Test
    void doesNotHuntItselfWhenAllHuntEachOther() {
        hunterAt(h1, 0, Map.of("prey", "hunter"));
        move(h1, 1);
        assertThat(scene.state("h1")).isEqualTo("looking for prey");
        scene.report("h2", "hunter", 10, 0);
        assertThat(h1.navigator.goals).containsExactly(at(10));
    }

    @Test
    void setsOffAgainAtTheInstantInWhichItHasStopped() {
        hunterAt(h1, 0, Map.of());
        scene.report("p1", "prey", 10, 0);
        scene.platform.publish("radio", Caught.TOPIC, new Caught("p1", "h2", 1));
        scene.platform.publish("radio", PoseReport.TOPIC, new PoseReport("p2", "prey", at(10)));
        scene.advance(0);
        assertThat(h1.navigator.driving()).isTrue();
    }

    @Test
    void nearestHuntersDivideThePreyWithTheLeastWayForAll() {
        FakeRobot h2 = scene.robot("h2", "hunter");
        hunterAt(h1, 0, NEAREST);
        hunterAt(h2, 6, NEAREST);
        scene.report("p1", "prey", 10, 0);
        scene.report("p2", "prey", 3, 0);
        scene.advance(2);
        assertThat(h1.navigator.goals.getLast()).isEqualTo(at(3));
        assertThat(h2.navigator.goals.getLast()).isEqualTo(at(10));
        assertThat(scene.said("h2", Chase.TOPIC).getLast()).isEqualTo(new Chase("h2", "p1"));

        scene.hear("p2", Caught.TOPIC, new Caught("p2", "h1", 1.9));
        assertThat(h1.navigator.goals.getLast()).isEqualTo(at(10)); // helps
        assertThat(h2.navigator.goals.getLast()).isEqualTo(at(10));
    }

    @Test
    void nearestHuntersTakeOverFromOneThatIsGone() {
        FakeRobot h2 = scene.robot("h2", "hunter");
        hunterAt(h1, 0, NEAREST);
        hunterAt(h2, 9, NEAREST);
        scene.report("p1", "prey", 10, 0);
        scene.report("p2", "prey", -20, 0);
        scene.advance(2);
        assertThat(h1.navigator.goals.getLast()).isEqualTo(at(-20));
        scene.platform.stop("h2");
        scene.report("p1", "prey", 10, 0);
        scene.advance(2);
        assertThat(h1.navigator.goals.getLast()).isEqualTo(at(10));
    }

    private void hunterAt(FakeRobot hunter, double x, Map<String, ?> arguments) {
        scene.start("follow", hunter, arguments);
        hunter.isAt(x, 0);
        scene.advance(0);
    }

    private void move(FakeRobot hunter, double x) {
        hunter.isAt(x, 0);
        scene.advance(0.5); // the period of its reports
    }

    private static Pose2d at(double x) {
        return new Pose2d(x, 0, 0);
    }
}
