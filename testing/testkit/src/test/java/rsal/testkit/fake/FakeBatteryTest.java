package rsal.testkit.fake;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.BatteryContract;

class FakeBatteryTest extends BatteryContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Test
    void showsWhatATestWants() {
        BatteryState dead = BatteryState.of(0, 100, 0, Charging.DISCHARGING);
        robot().require(FakeBattery.class).show(dead);
        assertThat(reading()).isEqualTo(dead);
        assertThat(reading().empty()).isTrue();
    }
}
