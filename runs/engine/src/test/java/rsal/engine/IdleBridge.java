package rsal.engine;

import java.util.List;
import rsal.robot.Robot;
import rsal.system.Bridge;
import rsal.system.ExportedDevice;

/// Offers nothing of the robots to anybody.
abstract class IdleBridge implements Bridge {
    @Override
    public List<ExportedDevice> offers() {
        return List.of();
    }

    @Override
    public List<ExportedDevice> join(Robot robot) {
        return List.of();
    }

    @Override
    public void leave(String robot) {}

    @Override
    public void close() {}
}
