package rsal.sim.device;

import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;

/// Makes simulated devices of a registered kind ([rsal.robot.DeviceKind]). Found by [java.util.ServiceLoader].
public interface SimulatedKind {
    /// The contract that its devices fulfil, as [rsal.robot.DeviceKind#makes] has it.
    Class<? extends Device> makes();

    /// Makes a device for a robot. It must fulfil the contract.
    SimulatedSensor<?> create(DeviceInfo info, Part.Registered part, SimulatedRobot robot);
}
