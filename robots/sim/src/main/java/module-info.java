/// The robot system `sim`: a simulated world in which robots drive, collide and sense, step by step in the
/// scheduler's time. Knows nothing of agents, scenarios or navigation.
module rsal.sim {
    requires transitive rsal.devices;
    requires static org.jspecify;

    exports rsal.sim.device;

    uses rsal.sim.device.SimulatedKind;

    provides rsal.sim.device.SimulatedKind with
            rsal.sim.device.SimCameraKind,
            rsal.sim.device.SimGnssKind,
            rsal.sim.device.SimImuKind;
    provides rsal.system.RobotSystemProvider with
            rsal.sim.SimProvider;
}
