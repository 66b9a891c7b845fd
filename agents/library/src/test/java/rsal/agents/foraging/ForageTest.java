package rsal.agents.foraging;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.agents.FakeBattery;
import rsal.agents.FakeCamera;
import rsal.agents.FakeHand;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.BatteryState.Charging;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.PlaceFinder;

/// A forager at the origin, with a lookout far in the north and a charger in the west.
class ForageTest {
    private static final Pose2d LOOKOUT = new Pose2d(0, 20, 0);
    private static final Pose2d CHARGER = new Pose2d(-8, 0, 0);

    private final Scene scene = new Scene();
    private final FakeRobot body = scene.robot("f", "forager");
    private final FakeHand hand = new FakeHand("f");
    private final FakeCamera camera = new FakeCamera("f");
    private final FakeBattery battery = new FakeBattery("f");

    @BeforeEach
    void begins() {
        body.places.result = new PlaceFinder.Result.Found(List.of(LOOKOUT.position()));
        body.wakeBase();
        body.isAt(0, 0);
        var robot = body.robot.with(hand).with(camera).with(battery).with(body.places);
        scene.start("forage", "f", Optional.of(robot), Map.of("chargers", "-8 0", "lowBattery", 0.3, "range", 10));
        scene.advance(3);
    }

    private Pose2d goal() {
        return body.navigator.goals.getLast();
    }

    private void charge(double level, Charging charging) {
        battery.is(level, charging, scene.scheduler.instant());
        scene.advance(0);
    }

    /// At a place, as the robot sees it from where it is.
    private void isSeenAhead(double range) {
        camera.show(FakeCamera.GREEN, range);
        scene.advance(0);
    }

    private void grips() {
        body.isAt(4, 0);
        body.navigator.reach();
        scene.advance(0.5);
        isSeenAhead(0.8);
        scene.advance(0.5);
        hand.somethingIsThere = true;
        hand.feel();
        scene.advance(0.5);
    }

    @Test
    void looksAroundUntilItSeesSomethingAndFetchesTheNearestOfAllThatItKnows() {
        assertThat(goal()).isEqualTo(LOOKOUT);
        isSeenAhead(5);
        assertThat(goal()).isEqualTo(new Pose2d(5, 0, 0));
        isSeenAhead(3); // it goes on to the first
        assertThat(goal()).isEqualTo(new Pose2d(5, 0, 0));
        assertThat(scene.view("f").beliefs()).containsEntry("things", "2 to fetch");
        body.navigator.end(new Result.NoPath("A wall."));
        for (int i = 0; i < 3; i++) {
            scene.advance(6);
            body.navigator.end(new Result.NoPath("A wall."));
        }
        scene.advance(6);
        assertThat(goal()).isEqualTo(new Pose2d(3, 0, 0));
    }

    @Test
    void bringsWhatItHoldsBeforeItGoesToTheCharger() {
        isSeenAhead(5);
        grips();
        charge(0.1, Charging.DISCHARGING);
        scene.advance(2);
        assertThat(goal()).as("its depot").isEqualTo(new Pose2d(0, 0, 0));
        body.isAt(0, 0);
        body.navigator.reach();
        scene.advance(4);
        assertThat(scene.said("f", Collected.TOPIC)).hasSize(1);
        assertThat(goal()).isEqualTo(CHARGER);
        body.navigator.reach();
        charge(0.5, Charging.CHARGING);
        scene.advance(6);
        assertThat(scene.state("f")).startsWith("charging");
        charge(0.95, Charging.CHARGING);
        scene.advance(1);
        assertThat(goal()).isEqualTo(LOOKOUT);
    }

    @Test
    void turnsBackToTheChargerWhileItsHandsAreEmptyAndFetchesLater() {
        isSeenAhead(5);
        charge(0.1, Charging.DISCHARGING);
        scene.advance(2);
        assertThat(goal()).isEqualTo(CHARGER);
        charge(0.95, Charging.CHARGING);
        scene.advance(2);
        assertThat(goal()).isEqualTo(new Pose2d(5, 0, 0));
    }

    @Test
    void goesToTheChargerInsteadOfWhatItKnowsOf() {
        charge(0.1, Charging.DISCHARGING);
        assertThat(goal()).isEqualTo(CHARGER);
        isSeenAhead(5);
        scene.advance(2);
        assertThat(goal()).isEqualTo(CHARGER);
        charge(0.95, Charging.CHARGING);
        scene.advance(1);
        assertThat(goal()).isEqualTo(new Pose2d(5, 0, 0));
    }

    @Test
    void takesNothingOutOfADepotBeItItsOwnOrAnothers() {
        assertThat(scene.said("f", Depot.TOPIC)).first().isEqualTo(new Depot("f/1", new Point2d(0, 0), 1.5));
        scene.hear("g", Depot.TOPIC, new Depot("g/1", new Point2d(6, 0), 1.5));
        isSeenAhead(1);
        isSeenAhead(5);
        scene.advance(2);
        assertThat(goal()).isEqualTo(LOOKOUT);
        isSeenAhead(3);
        assertThat(goal()).isEqualTo(new Pose2d(3, 0, 0));
    }

    @Test
    void whatItCouldNotFetchItLeavesAloneForAMinute() {
        isSeenAhead(5);
        for (int i = 0; i < 4; i++) {
            body.navigator.end(new Result.NoPath("A wall."));
            scene.advance(6);
        }
        isSeenAhead(5);
        scene.advance(1);
        assertThat(goal()).isEqualTo(LOOKOUT);
        scene.advance(60);
        isSeenAhead(5);
        assertThat(goal()).isEqualTo(new Pose2d(5, 0, 0));
    }
}
