package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.ActuatorContract;

class FakeActuatorTest extends ActuatorContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
