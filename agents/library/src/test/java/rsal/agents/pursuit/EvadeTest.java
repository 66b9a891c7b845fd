package rsal.agents.pursuit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agents.FakeBattery;
import rsal.agents.FakePlanner;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.BatteryState.Charging;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.PlaceFinder;

class EvadeTest {
    private static final Map<String, ?> HUNTED =
            Map.of("hunter", "hunter", "sensingRange", 10, "fleeDistance", 6, "chargers", "0 30");

    private final Scene scene = new Scene();
    private final FakeRobot p1 = scene.robot("p1", "prey");
    private final FakeBattery battery = new FakeBattery("p1");

    private void preyAtOrigin() {
        preyAtOrigin("0 30");
    }

    private void preyAtOrigin(String chargers) {
        p1.places.result =
                new PlaceFinder.Result.Found(List.of(new Point2d(20, 0), new Point2d(-20, 0), new Point2d(0, 15)));
        begin(chargers);
    }

    private void begin(String chargers) {
        var robot = p1.robot.with(p1.places).with(battery).with(new FakePlanner("p1"));
        var arguments = new HashMap<String, Object>(HUNTED);
        arguments.put("chargers", chargers);
        scene.start("evade", "p1", Optional.of(robot), arguments);
        p1.isAt(0, 0);
        scene.advance(0);
    }

    @Test
    void exploresUntilAHunterIsNearAndRunsWhereItHasTheGreatestLead() {
        preyAtOrigin();
        assertThat(scene.view("p1").beliefs()).containsEntry("nearest hunter", "∞");
        scene.report("h1", "hunter", 9, 0);
        scene.advance(2);
        assertThat(scene.state("p1")).isEqualTo("explore: follow the wall");
        assertThat(p1.pilot.engaged()).isTrue();
        scene.report("h1", "hunter", 5, 0);
        scene.advance(0);
        assertThat(scene.state("p1")).isEqualTo("not be caught: run");
        assertThat(p1.navigator.goals).containsExactly(new Pose2d(-20, 0, 0));
        assertThat(p1.pilot.engaged()).isFalse();
    }

    @Test
    void runsOnWhereItsLeadGetsNoGreater() {
        p1.places.result = new PlaceFinder.Result.Found(List.of(new Point2d(-5, 0), new Point2d(-20, 0)));
        begin("0 30");
        scene.report("h1", "hunter", 5, 0);
        scene.advance(0);
        assertThat(p1.navigator.goals).containsExactly(new Pose2d(-20, 0, 0));
    }

    @Test
    void standsWhereEachPathLeadsToTheHunter() {
        p1.places.result = new PlaceFinder.Result.Found(List.of(new Point2d(5, 0), new Point2d(8, 0)));
        begin("0 30");
        scene.report("h1", "hunter", 4, 0);
        scene.advance(2);
        assertThat(p1.navigator.goals).isEmpty();
        assertThat(p1.pilot.engaged()).as("it follows no wall").isFalse();
    }

    @Test
    void runsToAnotherPlaceOnlyIfThatIsClearlyBetter() {
        p1.places.result = new PlaceFinder.Result.Found(List.of(new Point2d(-10, 1), new Point2d(-10, -1)));
        begin("0 30");
        scene.report("h1", "hunter", 5, 0.5);
        scene.advance(0);
        assertThat(p1.navigator.goals).containsExactly(new Pose2d(-10, -1, 0));
        for (int i = 1; i <= 3; i++) {
            scene.report("h1", "hunter", 5, i % 2 == 0 ? 0.5 : -0.5);
            scene.advance(1);
        }
        assertThat(p1.navigator.goals).containsExactly(new Pose2d(-10, -1, 0));
    }

    @Test
    void goesOnExploringWhenTheHunterIsFarOrForgotten() {
        preyAtOrigin();
        scene.report("h1", "hunter", 5, 0);
        scene.advance(2);
        scene.report("h1", "hunter", 7, 0);
        scene.advance(2);
        assertThat(scene.state("p1")).as("not far enough").isEqualTo("not be caught: run");
        scene.report("h1", "hunter", 8, 0);
        scene.advance(0);
        assertThat(scene.state("p1")).isEqualTo("explore: follow the wall");
        assertThat(p1.navigator.driving()).isFalse();
        scene.report("h1", "hunter", 5, 0);
        scene.advance(0);
        assertThat(p1.navigator.driving()).isTrue();
        scene.advance(5);
        p1.isAt(-2, 0);
        scene.advance(1);
        assertThat(scene.state("p1")).isEqualTo("explore: follow the wall");
    }

    @Test
    void preyWarnEachOtherOfWhatTheySee() {
        preyAtOrigin();
        scene.report("h1", "hunter", 9, 0);
        scene.report("h2", "hunter", 11, 0); // too far to be seen
        assertThat(scene.said("p1", Sighting.TOPIC)).containsExactly(new Sighting("h1", "hunter", new Pose2d(9, 0, 0)));
        scene.hear("p2", Sighting.TOPIC, new Sighting("h3", "hunter", new Pose2d(-5, 0, 0)));
        scene.advance(0);
        assertThat(p1.navigator.goals).containsExactly(new Pose2d(0, 15, 0));
    }

    @Test
    void waysPastHuntersAreNone() {
        preyAtOrigin();
        scene.report("h1", "hunter", 4, 0);
        scene.report("h2", "hunter", -5, 0);
        scene.advance(4);
        assertThat(p1.navigator.goals).last().isEqualTo(new Pose2d(0, 15, 0));
    }

    @Test
    void caughtItGivesUpForGood() {
        preyAtOrigin();
        scene.report("h1", "hunter", 1, 0);
        scene.advance(3);
        assertThat(scene.said("p1", Caught.TOPIC)).containsExactly(new Caught("p1", "h1", 1));
        assertThat(scene.state("p1")).isEqualTo("caught by h1");
        assertThat(p1.navigator.driving()).isFalse();
        assertThat(p1.pilot.engaged()).as("it spins").isTrue();
        scene.advance(60);
        assertThat(p1.pilot.engaged()).isFalse();
    }

    @Test
    void rechargesWhenItsBatteryIsLowUnlessItHasToRun() {
        preyAtOrigin();
        charge(0.2, Charging.DISCHARGING);
        scene.advance(1);
        assertThat(p1.navigator.goals).containsExactly(new Pose2d(0, 30, 0));
        scene.report("h1", "hunter", 5, 0);
        scene.advance(0);
        assertThat(p1.navigator.goals).last().isEqualTo(new Pose2d(-20, 0, 0));
        scene.report("h1", "hunter", 9, 0);
        scene.advance(1);
        assertThat(p1.navigator.goals).last().isEqualTo(new Pose2d(0, 30, 0));
        p1.navigator.end(new Result.Reached(new Pose2d(0, 30, 0)));
        charge(0.6, Charging.CHARGING);
        scene.advance(1);
        assertThat(scene.state("p1")).isEqualTo("charging at (0.0, 30.0)");
        charge(0.95, Charging.CHARGING);
        scene.advance(1);
        assertThat(scene.state("p1")).isEqualTo("explore: follow the wall");
    }

    @Test
    void oneThatWasInterruptedAtAChargerGoesToOneAndNotToAndFro() {
        preyAtOrigin("0 30; 0 -30");
        charge(0.2, Charging.DISCHARGING);
        scene.advance(1);
        p1.navigator.reach();
        charge(0.3, Charging.CHARGING);
        scene.advance(1);
        scene.report("h1", "hunter", 5, 0);
        scene.advance(1);
        charge(0.3, Charging.DISCHARGING);
        scene.report("h1", "hunter", 9, 0);
        scene.advance(1);
        int goals = p1.navigator.goals.size();
        assertThat(p1.navigator.goals.getLast().x()).isZero();
        scene.advance(30);
        assertThat(p1.navigator.goals).hasSize(goals);
    }

    private void charge(double level, Charging charging) {
        battery.is(level, charging, scene.scheduler.instant());
        scene.advance(0);
    }
}
