package rsal.testkit.fake;

import rsal.robot.RobotSystemProvider;
import rsal.testkit.contract.BatteryContract;

class FakeBatteryTest extends BatteryContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
