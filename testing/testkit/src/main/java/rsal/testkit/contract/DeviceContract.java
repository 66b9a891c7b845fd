package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import org.junit.jupiter.api.Test;
import rsal.device.Device;
import rsal.device.Health;

/// What every device of a robot owes.
public abstract class DeviceContract<D extends Device> extends RobotBench {
    private final Class<D> type;

    protected DeviceContract(Class<D> type) {
        this.type = type;
    }

    protected final D device() {
        return robot().require(type);
    }

    @Test
    void saysWhoItIs() {
        assertThat(device().info().robot()).isEqualTo("r1");
        assertThat(device().info().name()).isNotBlank();
        assertThat(device().info().driver()).isNotBlank();
        assertThat(robot().devices().stream().map(d -> d.info().id())).doesNotHaveDuplicates();
    }

    @Test
    void isWellWhenNothingIsWrong() {
        var reported = new ArrayList<Health>();
        device().onHealth(reported::add);
        advance(2);
        assertThat(device().health().isOk()).isTrue();
        assertThat(reported).as("not for a moment").allMatch(Health::isOk);
    }
}
