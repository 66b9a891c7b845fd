package rsal.agents.rescue;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.agents.FakeFinder;
import rsal.agents.FakeMapper;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;

/// Agents of types `scout`, `helper` and `rescue` together.
class RescueTest {
    private final Scene scene = new Scene();
    private final Map<String, FakeRobot> robots = new TreeMap<>();
    private final Map<String, FakeFinder> finders = new TreeMap<>();
    private final Map<String, FakeMapper> mappers = new TreeMap<>();

    @BeforeEach
    void somebodyKeepsTheBooks() {
        scene.start("rescue", "rescue", Optional.empty(), Map.of());
    }

    /// @param waits whether its robot explores only when told to
    private void robot(String type, String id, double x, boolean waits, Map<String, ?> arguments) {
        FakeRobot robot = scene.robot(id, type);
        var finder = new FakeFinder(id);
        var mapper = new FakeMapper(id, waits);
        robots.put(id, robot);
        finders.put(id, finder);
        mappers.put(id, mapper);
        robot.isAt(x, 0);
        scene.start(type, id, Optional.of(robot.robot.with(finder).with(mapper)), arguments);
        scene.advance(0);
    }

    private void scout(double x) {
        robot("scout", "scout", x, false, Map.of());
    }

    private void helper(String id, double x) {
        robot("helper", id, x, true, Map.of("stayTime", 10));
    }

    private void sees(String id, int victim, double ahead) {
        finders.get(id).sees(OptionalInt.of(victim), ahead, 0, scene.scheduler.instant());
        scene.advance(0);
    }

    private void seesNothing(String id) {
        finders.get(id).seesNothing(scene.scheduler.instant());
        scene.advance(0);
    }

    private Pose2d goal(String id) {
        return robots.get(id).navigator.goals.getLast();
    }

    private boolean driving(String id) {
        return robots.get(id).navigator.driving();
    }

    private void stands(String id, double x) {
        robots.get(id).isAt(x, 0);
        scene.advance(0);
    }

    @Test
    void whoIsNearGoesToAVictimThatWasFoundAndStaysWithIt() {
        scout(5);
        helper("near", 0);
        helper("far", -20);
        sees("scout", 3, 2);
        assertThat(scene.said("scout", VictimFound.TOPIC))
                .containsExactly(new VictimFound("scout", 3, new Point2d(7, 0)));
        assertThat(goal("near").x()).isEqualTo(7);
        assertThat(driving("far")).isFalse();
        stands("near", 6);
        sees("near", 3, 1);
        scene.advance(0.5);
        assertThat(driving("near")).as("it has come near enough").isFalse();
        assertThat(scene.state("near")).isEqualTo("helping victim 3");
        scene.advance(9);
        assertThat(scene.said("rescue", VictimHelped.TOPIC)).isEmpty();
        scene.advance(1.5);
        assertThat(scene.said("rescue", VictimHelped.TOPIC)).containsExactly(new VictimHelped(3));
        assertThat(scene.state("rescue")).isEqualTo("1 victim found, 1 helped");
    }

    @Test
    void whoGoesThereMustSeeItThereAndElseAnotherGoes() {
        scout(5);
        helper("near", 0);
        helper("far", -20);
        sees("scout", 3, 2);
        stands("near", 6);
        for (int tries = 0; tries < 5 && driving("near"); tries++) {
            robots.get("near").navigator.reach(); // and there is nothing
            seesNothing("near");
            scene.advance(0.6);
        }
        scene.advance(2);
        assertThat(driving("near")).isFalse();
        assertThat(goal("far").x()).isEqualTo(7);
        assertThat(scene.said("rescue", VictimHelped.TOPIC)).isEmpty();
    }

    @Test
    void whoseWayIsBlockedLeavesItToAnother() {
        scout(5);
        helper("near", 0);
        helper("far", -20);
        sees("scout", 3, 2);
        robots.get("near").navigator.end(new Result.NoPath("A wall."));
        scene.advance(1);
        assertThat(goal("far").x()).isEqualTo(7);
    }

    @Test
    void whoIsUnderWayFollowsNewerWordsOfWhereItIs() {
        scout(5);
        helper("near", 0);
        sees("scout", 3, 2);
        sees("scout", 3, 2.8);
        scene.advance(1);
        assertThat(goal("near").x()).isEqualTo(7.8);
    }

    @Test
    void aVictimIsReportedAgainUntilSomebodySaysThatItWasHelped() {
        scout(5);
        sees("scout", 3, 2);
        scene.advance(16);
        assertThat(scene.said("scout", VictimFound.TOPIC)).hasSize(4);
        scene.hear("rescue", VictimHelped.TOPIC, new VictimHelped(3));
        sees("scout", 3, 4);
        scene.advance(16);
        assertThat(scene.said("scout", VictimFound.TOPIC)).hasSize(4);
    }

    @Test
    void markersThatCannotBeReadAreNotReported() {
        scout(5);
        finders.get("scout").sees(OptionalInt.empty(), 7, 0, scene.scheduler.instant());
        scene.advance(10);
        assertThat(scene.said("scout", VictimFound.TOPIC)).isEmpty();
    }

    @Test
    void helpersThatWaitedDriveBackAndExplorersGoOn() {
        helper("waits", 0);
        robot("helper", "explores", 40, false, Map.of("stayTime", 0));
        scene.advance(6);
        sees("explores", 1, 3);
        assertThat(mappers.get("explores").paused()).isTrue();
        stands("explores", 42);
        sees("explores", 1, 1);
        scene.advance(1.1);
        assertThat(mappers.get("explores").paused()).isFalse();
        seesNothing("explores");
        stands("waits", 8);
        scene.advance(6);
        assertThat(goal("waits").x()).isZero();
        assertThat(driving("explores")).isFalse();
        assertThat(mappers.get("waits").paused()).isTrue();
    }

    @Test
    void explorersDriveBackWhenAllIsMappedAndGoOnWhenThereIsMore() {
        scout(5);
        scene.advance(2);
        stands("scout", 30);
        scene.advance(20);
        assertThat(driving("scout")).as("while there is something to map").isFalse();
        mappers.get("scout").isComplete(true, scene.scheduler.instant());
        scene.advance(7);
        assertThat(scene.state("scout")).isEqualTo("all is mapped");
        assertThat(goal("scout").x()).isEqualTo(5);
        assertThat(mappers.get("scout").paused())
                .as("it goes on as soon as there is more")
                .isFalse();
        mappers.get("scout").isComplete(false, scene.scheduler.instant());
        scene.advance(0);
        assertThat(scene.state("scout")).isEqualTo("exploring");
        robots.get("scout").navigator.reach(); // as when the mapper takes the robot over
        scene.advance(20);
        assertThat(driving("scout")).isFalse();
    }

    @Test
    void explorersStayWhereTheyAreIfAskedTo() {
        robot("scout", "stays", 5, false, Map.of("returns", false));
        scene.advance(2);
        stands("stays", 30);
        mappers.get("stays").isComplete(true, scene.scheduler.instant());
        scene.advance(20);
        assertThat(driving("stays")).isFalse();
    }

    @Test
    void peopleComeFirst() {
        scout(5);
        helper("near", 0);
        helper("far", -20);
        sees("scout", 3, 2);
        scene.order("near", 1, 5);
        assertThat(goal("near").y()).isEqualTo(5);
        scene.advance(1);
        assertThat(goal("far").x()).isEqualTo(7);
        scene.order("scout", 2, 2);
        assertThat(mappers.get("scout").paused()).isTrue();
        robots.get("scout").navigator.reach();
        scene.advance(0);
        assertThat(mappers.get("scout").paused()).isFalse();
    }
}
