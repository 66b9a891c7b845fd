package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.LightState;
import rsal.data.LightState.Signal;
import rsal.device.Light;
import rsal.robot.RobotModel.Part;

/// What every [Light] owes.
public abstract class LightContract extends SensorContract<LightState, Light> {
    protected LightContract() {
        super(Light.class, "r1/light");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("light", "beacon");
    }

    private Part.Light part() {
        return (Part.Light) java.util.Objects.requireNonNull(model().sensors().get("light"));
    }

    /// Share of readings in which it shines.
    private double lit(double seconds) {
        var lit = new ArrayList<Boolean>();
        try (var _ = device().subscribe(reading -> lit.add(reading.value().lit()))) {
            advance(seconds);
        }
        assertThat(lit).hasSizeGreaterThan(10);
        return (double) lit.stream().filter(l -> l).count() / lit.size();
    }

    @Test
    void atFirstItDoesWhatItsModelSays() {
        LightState state = reading();
        assertThat(state.color()).isEqualTo(part().color());
        assertThat(state.signal()).isEqualTo(part().signal());
        assertThat(lit(10)).isCloseTo(part().signal().dutyCycle(), within(0.1));
    }

    @Test
    void isOnAndOffAsCommanded() {
        device().on();
        advance(0.3);
        assertThat(lit(3)).isEqualTo(1);
        device().off();
        advance(0.3);
        assertThat(lit(3)).isZero();
        assertThat(reading().signal()).isEqualTo(Signal.OFF);
    }

    @Test
    void flashesForItsShareOfThePeriod() {
        var signal = new Signal(Duration.ofSeconds(2), 0.25);
        device().show(signal);
        assertThat(reading().signal()).isEqualTo(signal);
        assertThat(lit(20)).isCloseTo(0.25, within(0.05));
    }

    @Test
    void beginsWithAFlash() {
        device().off();
        advance(1.3);
        device().show(new Signal(Duration.ofSeconds(4), 0.5));
        advance(0.5);
        assertThat(lit(1.2)).isEqualTo(1);
    }

    @Test
    void theNewestWins() {
        device().on();
        device().off();
        advance(0.3);
        assertThat(lit(2)).isZero();
    }
}
