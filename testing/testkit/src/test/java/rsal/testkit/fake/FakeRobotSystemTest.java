package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotSystemContract;

class FakeRobotSystemTest extends RobotSystemContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
