/// The values that robots and agents exchange: poses, velocities, scans, maps, estimates, with their units and
/// frames. Knows nothing of devices, agents, files or time keeping.
module rsal.data {
    requires static org.jspecify;

    exports rsal.data;
}
