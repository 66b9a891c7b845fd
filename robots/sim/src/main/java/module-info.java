/// The robot system `sim`: a simulated world in which robots drive, collide and sense, step by step in the
/// scheduler's time. Knows nothing of agents, scenarios or navigation.
module rsal.sim {
    requires rsal.devices;
    requires static org.jspecify;

    provides rsal.system.RobotSystemProvider with
            rsal.sim.SimProvider;
}
