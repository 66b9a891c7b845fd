package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.SonarArrayContract;

class FakeSonarArrayTest extends SonarArrayContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
