package rsal.testkit.fake;

import java.util.List;
import rsal.robot.DeviceDriver;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.DockingContract;

class FakeDockingTest extends DockingContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakeDocking.Driver());
    }
}
