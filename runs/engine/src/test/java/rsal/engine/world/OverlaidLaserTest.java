package rsal.engine.world;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.LaserScannerContract;

class OverlaidLaserTest extends LaserScannerContract {
    @Override
    protected RobotSystemProvider provider() {
        return new Overlaid();
    }
}
