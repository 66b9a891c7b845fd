package rsal.testkit.fake;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.BumperContract;

class FakeBumperTest extends BumperContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Test
    void showsWhatATestWants() {
        robot().require(FakeBumper.class).show(true, false, false, false, false, false, false, false);
        assertThat(reading().any()).isTrue();
    }
}
