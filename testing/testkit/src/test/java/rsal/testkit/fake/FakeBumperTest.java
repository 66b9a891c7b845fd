package rsal.testkit.fake;

import rsal.robot.RobotSystemProvider;
import rsal.testkit.contract.BumperContract;

class FakeBumperTest extends BumperContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
