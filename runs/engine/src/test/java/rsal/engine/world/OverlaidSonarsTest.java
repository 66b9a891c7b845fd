package rsal.engine.world;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.SonarArrayContract;

class OverlaidSonarsTest extends SonarArrayContract {
    @Override
    protected RobotSystemProvider provider() {
        return new Overlaid();
    }
}
