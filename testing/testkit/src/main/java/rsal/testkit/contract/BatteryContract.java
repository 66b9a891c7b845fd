package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Twist2d;
import rsal.device.Battery;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel.Part;

/// What every [Battery] owes.
public abstract class BatteryContract extends SensorContract<BatteryState, Battery> {
    protected BatteryContract() {
        super(Battery.class, "r1/base_link");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("battery", "pioneer-battery");
    }

    private Part.Battery part() {
        return (Part.Battery) java.util.Objects.requireNonNull(model().sensors().get("battery"));
    }

    private BatteryState state() {
        return device().latest().orElseThrow().value();
    }

    @Test
    void holdsWhatItsModelHolds() {
        BatteryState state = reading();
        assertThat(state.capacity()).isCloseTo(part().capacity(), within(1.0));
        assertThat(state.charge()).isBetween(part().charge() - 10 * part().idlePower(), part().charge());
        assertThat(state.level()).isCloseTo(state.charge() / state.capacity(), within(1e-6));
        assertThat(state.empty()).isFalse();
    }

    @Test
    void standingStillItLosesWhatTheRobotTakes() {
        double before = reading().charge();
        advance(10);
        assertThat(before - state().charge()).isCloseTo(10 * part().idlePower(), within(1.0));
        assertThat(state().power()).isCloseTo(-part().idlePower(), within(0.1));
        assertThat(state().charging()).isEqualTo(Charging.DISCHARGING);
    }

    @Test
    void drivingAndTurningTakeMore() {
        double before = reading().charge();
        drive(Twist2d.drive(0.4, 0), 10);
        double driving = before - state().charge();
        double expected = 10 * part().idlePower() + 3.9 * part().energyPerMeter();
        assertThat(driving).isCloseTo(expected, within(0.3 * part().energyPerMeter()));
        advance(2);
        before = state().charge();
        drive(Twist2d.drive(0, 1), 10);
        double turning = before - state().charge();
        assertThat(turning).isCloseTo(10 * part().idlePower() + 9.8 * part().energyPerRadian(), within(6.0));
    }

    @Test
    void aChargingStationFillsItUntilTheRobotLeaves() {
        advance(30);
        Solid plate = Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.3), 0.02);
        put(Thing.of("station", START, plate, new Rgb(255, 255, 0)).giving(40));
        double before = reading().charge();
        advance(5);
        assertThat(state().charging()).isEqualTo(Charging.CHARGING);
        assertThat(state().charge() - before).isCloseTo(5 * (40 - part().idlePower()), within(2.0));
        simulation().place("r1", START.compose(new Pose2d(2, 0, 0)));
        advance(1);
        assertThat(state().charging()).isEqualTo(Charging.DISCHARGING);
        assertThat(state().power()).isNegative();
    }

    @Test
    void takesInNoMoreThanItCan() {
        drive(Twist2d.drive(0.4, 0), 5);
        advance(30);
        Solid plate = Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.3), 0.02);
        put(Thing.of("station", truth(), plate, new Rgb(255, 255, 0)).giving(900));
        advance(1);
        double before = state().charge();
        advance(5);
        assertThat(state().charge() - before).isCloseTo(5 * (part().chargingPower() - part().idlePower()), within(2.0));
    }
}
