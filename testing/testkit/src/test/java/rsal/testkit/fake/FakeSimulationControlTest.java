package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.SimulationControlContract;

class FakeSimulationControlTest extends SimulationControlContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
