package rsal.navigation.device;

import java.util.List;
import rsal.robot.DeviceDriver;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.PlannerContract;

class JumpPointPlannerTest extends PlannerContract {
    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new JumpPointDriver());
    }
}
