package rsal.agents.foraging;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Directory;
import rsal.agents.FakeCamera;
import rsal.agents.FakeHand;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.device.Navigator;
import rsal.robot.Robot;

/// One that finds things and those that fetch them. Where an agent has no planner, ways are straight.
class CollectTest {
    private static final Rgb RED = Rgb.of(0xff0000);

    private final Scene scene = new Scene();
    private final Collector near = new Collector("near", 0, 0);
    private final Collector far = new Collector("far", 20, 0);
    private final FakeRobot finder = scene.robot("finder", "explorer");
    private final FakeCamera eye = new FakeCamera("finder");

    private final class Collector {
        private final FakeRobot body;
        private final FakeHand hand;
        private final FakeCamera camera;
        private final Robot robot;

        Collector(String id, double x, double y) {
            body = scene.robot(id, "collector");
            hand = new FakeHand(id);
            camera = new FakeCamera(id);
            robot = body.robot.with(hand).with(camera);
            body.wakeBase();
            body.isAt(x, y);
        }

        void start() {
            scene.start("collect", robot.id(), Optional.of(robot), Map.of());
        }
    }

    private void explore(Map<String, ?> arguments) {
        finder.wakeBase();
        finder.isAt(3, 0);
        scene.start("explore", "finder", Optional.of(finder.robot.with(eye)), arguments);
    }

    private void master(Map<String, ?> arguments) {
        scene.start("fetch", "master", Optional.empty(), arguments);
    }

    /// Both stand at their depots, and the explorer sees something 1 m ahead of (3, 0).
    private void find() {
        near.start();
        far.start();
        master(Map.of());
        explore(Map.of());
        scene.advance(3);
        eye.show(FakeCamera.GREEN, 1);
        scene.advance(1);
    }

    @Test
    void whoHasTheShorterWayFetchesIt() {
        find();
        assertThat(near.body.navigator.goals).containsExactly(new Pose2d(4, 0, 0));
        assertThat(far.body.navigator.goals).isEmpty();
        assertThat(scene.state("near")).isEqualTo("driving to #2ca02c at (4.0, 0.0)");
    }

    @Test
    void whoIsFreeFetchesItWhenNobodyBids() {
        far.start();
        near.start();
        master(Map.of("allocation", "first"));
        explore(Map.of());
        scene.advance(3);
        eye.show(FakeCamera.GREEN, 1);
        scene.advance(1);
        assertThat(far.body.navigator.goals).hasSize(1); // was there first
        assertThat(near.body.navigator.goals).isEmpty();
        eye.show(FakeCamera.GREEN, 2);
        scene.advance(1);
        assertThat(near.body.navigator.goals).containsExactly(new Pose2d(5, 0, 0));
    }

    @Test
    void theSameThingSeenAgainIsNoOther() {
        find();
        for (int look = 0; look < 300; look++) {
            eye.show(FakeCamera.GREEN, look % 2 == 0 ? 1 : 1.1);
            scene.advance(0.1);
        }
        assertThat(scene.said("finder", CollectGoal.TOPIC))
                .allMatch(goal -> goal.mapFromThing().x() == 4);
        assertThat(near.body.navigator.goals).hasSize(1);
        assertThat(far.body.navigator.goals).isEmpty();
    }

    @Test
    void whatIsOfAnotherColorTooFarOrHalfHiddenDoesNotCount() {
        near.start();
        explore(Map.of("color", "#2ca02c", "range", 2.0));
        scene.advance(3);
        eye.show(RED, 1);
        eye.show(FakeCamera.GREEN, 2.1);
        eye.showAtTheBorder(FakeCamera.GREEN, 1);
        scene.advance(3);
        assertThat(scene.said("finder", CollectGoal.TOPIC)).isEmpty();
    }

    @Test
    void whatLiesInADepotOrWhereARobotIsIsLeftThere() {
        near.start();
        explore(Map.of("range", 10.0));
        finder.isAt(-3, 0);
        scene.advance(3);
        eye.show(FakeCamera.GREEN, 3.5); // at (0.5, 0)
        scene.advance(1);
        scene.report("passer-by", "other", 3, 0.3);
        eye.show(FakeCamera.GREEN, 6);
        scene.advance(1);
        assertThat(scene.said("finder", CollectGoal.TOPIC)).isEmpty();
    }

    @Test
    void itGripsBringsAndReleases() {
        find();
        near.body.isAt(3.2, 0);
        scene.advance(0.5);
        near.body.navigator.reach();
        scene.advance(0.5);
        assertThat(near.hand.reported).containsExactly("close", "lift", "lower", "open");
        assertThat(scene.state("near")).startsWith("aiming");

        near.camera.show(FakeCamera.GREEN, 0.8);
        scene.advance(0.5);
        assertThat(near.body.base.commands.getLast().vx()).isPositive();

        near.hand.somethingIsThere = true;
        near.hand.feel();
        scene.advance(0.5);
        assertThat(near.hand.reported).endsWith("close", "lift");
        assertThat(near.body.navigator.goals.getLast()).isEqualTo(new Pose2d(0, 0, 0));
        assertThat(scene.said("near", Collected.TOPIC)).isEmpty();

        near.body.navigator.reach();
        scene.advance(4);
        assertThat(near.hand.reported).endsWith("lower", "open");
        assertThat(scene.said("near", Collected.TOPIC)).singleElement().satisfies(collected -> {
            assertThat(collected.robot()).isEqualTo("near");
            assertThat(collected.mapFromDepot().x()).isZero();
        });
    }

    @Test
    void whatItDoesNotHoldItHasNotCollected() {
        find();
        near.body.isAt(3.2, 0);
        near.body.navigator.reach();
        scene.advance(0.5);
        near.camera.show(FakeCamera.GREEN, 0.8);
        near.hand.somethingIsThere = true;
        near.hand.feel();
        scene.advance(0.5);
        near.hand.open(); // it slips
        near.body.navigator.reach();
        scene.advance(1);
        assertThat(scene.said("near", Collected.TOPIC)).isEmpty();
        scene.advance(3);
        assertThat(far.body.navigator.goals).containsExactly(new Pose2d(4, 0, 0)); // another tries
    }

    @Test
    void aWayThatLeadsNowhereIsTriedAgainAndThenLeftToOthers() {
        find();
        for (int attempt = 1; attempt <= 4; attempt++) {
            assertThat(near.body.navigator.goals).hasSize(attempt);
            near.body.navigator.end(new Navigator.Result.NoPath("A wall is in the way."));
            scene.advance(attempt < 4 ? 5.2 : 0.5);
        }
        assertThat(scene.said("near", Collected.TOPIC)).isEmpty();
        assertThat(near.body.navigator.goals.size() + far.body.navigator.goals.size())
                .isEqualTo(5);
    }

    @Test
    void anotherFetchesItWhenOneHasGone() {
        find();
        scene.platform.stop("near");
        scene.advance(3);
        assertThat(far.body.navigator.goals).containsExactly(new Pose2d(4, 0, 0));
    }

    @Test
    void whatSomebodyKnowsOfIsFetchedOnce() {
        near.start();
        master(Map.of());
        scene.advance(3);
        scene.start("blob", "told", Optional.empty(), Map.of("places", "4 0; 5 3"));
        scene.advance(1);
        assertThat(scene.state("told")).isEqualTo("0 of 2 fetched");
        assertThat(near.body.navigator.goals).containsExactly(new Pose2d(4, 0, 0));

        scene.hear("far", Collected.TOPIC, new Collected("far", green(4.2, 0), new Point2d(20, 0)));
        scene.hear("far", Collected.TOPIC, new Collected("far", green(5, 3), new Point2d(20, 0)));
        assertThat(scene.state("told")).isEqualTo("2 of 2 fetched");
    }

    @Test
    void whatSomebodyKnowsOfIsAskedForUntilThereIsATeam() {
        scene.start("blob", "told", Optional.empty(), Map.of("places", "4 0"));
        scene.advance(10);
        near.start();
        master(Map.of());
        scene.advance(5);
        assertThat(near.body.navigator.goals).containsExactly(new Pose2d(4, 0, 0));
    }

    @Test
    void reportsThatItHasAGripper() {
        near.start();
        explore(Map.of());
        assertThat(scene.platform.directory().offering("gripper"))
                .extracting(Directory.Entry::name)
                .containsExactly("near");
    }

    private static CollectGoal green(double x, double y) {
        return new CollectGoal(FakeCamera.GREEN, new Point2d(x, y));
    }
}
