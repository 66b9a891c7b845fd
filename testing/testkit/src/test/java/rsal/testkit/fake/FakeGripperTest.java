package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.GripperContract;

class FakeGripperTest extends GripperContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
