package rsal.testkit.fake;

import rsal.robot.RobotSystemProvider;
import rsal.testkit.contract.LightContract;

class FakeLightTest extends LightContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
