package rsal.testkit.fake;

import rsal.robot.RobotSystemProvider;
import rsal.testkit.contract.FiducialFinderContract;

class FakeFiducialFinderTest extends FiducialFinderContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
