package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.Angles;
import rsal.data.Twist2d;
import rsal.device.imu.Imu;
import rsal.device.imu.ImuKind;
import rsal.device.imu.ImuReading;
import rsal.robot.RobotModel.Part;
import rsal.settings.Arguments;

/// What every [Imu] owes.
public abstract class ImuContract extends SensorContract<ImuReading, Imu> {
    private static final int SIGMAS = 3; // of what is measured; offsets are drawn once

    private static final Twist2d CIRCLE = Twist2d.drive(0.3, -0.6);

    protected ImuContract() {
        super(Imu.class, "r1/imu");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("imu", "imu-bmi088");
    }

    private Part.Registered part() {
        return (Part.Registered)
                java.util.Objects.requireNonNull(model().sensors().get("imu"));
    }

    /// By how much an angular velocity may be off [rad/s].
    private double angularError() {
        Arguments noise = part().arguments();
        double white = noise.radians(ImuKind.GYROSCOPE_NOISE)
                / Math.sqrt(part().period().toNanos() / 1e9);
        return SIGMAS * (white + noise.radians(ImuKind.GYROSCOPE_BIAS)) + 1e-9;
    }

    /// By how much an acceleration may be off [m/s²].
    private double accelerationError() {
        Arguments noise = part().arguments();
        double white = noise.get(ImuKind.ACCELEROMETER_NOISE)
                / Math.sqrt(part().period().toNanos() / 1e9);
        return SIGMAS * (white + noise.get(ImuKind.ACCELEROMETER_BIAS)) + 1e-9;
    }

    @Test
    void standingItFeelsNoMotionAndNoGravity() {
        ImuReading reading = reading();
        assertThat(reading.angularVelocity()).isCloseTo(0, within(angularError()));
        assertThat(reading.accelerationX()).isCloseTo(0, within(accelerationError()));
        assertThat(reading.accelerationY()).isCloseTo(0, within(accelerationError()));
    }

    @Test
    void turningLeftIsPositive() {
        double before = reading().orientation();
        drive(Twist2d.drive(0, 0.5), 4);
        assertThat(device().latest().orElseThrow().value().angularVelocity()).isCloseTo(0.5, within(angularError()));
        advance(2);
        double turned = Angles.difference(
                before, device().latest().orElseThrow().value().orientation());
        double drift = 6 * SIGMAS * part().arguments().radians(ImuKind.GYROSCOPE_BIAS);
        assertThat(turned).isCloseTo(Angles.difference(START.theta(), truth().theta()), within(drift + angularError()));
    }

    /// The acceleration on a circle is ω v, to its middle.
    @Test
    void aCirclePushesItToItsMiddle() {
        drive(CIRCLE, 4);
        var sum = new ArrayList<ImuReading>();
        device().subscribe(stamped -> sum.add(stamped.value()));
        drive(CIRCLE, 2);
        double left =
                sum.stream().mapToDouble(ImuReading::accelerationY).average().orElseThrow();
        double ahead =
                sum.stream().mapToDouble(ImuReading::accelerationX).average().orElseThrow();
        assertThat(left).isCloseTo(CIRCLE.vx() * CIRCLE.omega(), within(accelerationError()));
        assertThat(ahead).isCloseTo(0, within(accelerationError()));
    }

    @Test
    void reportsAsOftenAsItsModelSays() {
        reading();
        var reported = new ArrayList<ImuReading>();
        device().subscribe(stamped -> reported.add(stamped.value()));
        advance(2);
        double expected =
                2.0 * Duration.ofSeconds(1).toNanos() / Math.max(part().period().toNanos(), STEP.toNanos());
        assertThat((double) reported.size()).isGreaterThanOrEqualTo(0.9 * expected);
    }
}
