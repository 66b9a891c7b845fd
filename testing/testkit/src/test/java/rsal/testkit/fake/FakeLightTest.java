package rsal.testkit.fake;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.data.LightState.Signal;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.LightContract;

class FakeLightTest extends LightContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Test
    void remembersEverySignal() {
        robot().require(FakeLight.class).on();
        robot().require(FakeLight.class).off();
        assertThat(robot().require(FakeLight.class).signals()).containsExactly(Signal.ON, Signal.OFF);
    }
}
