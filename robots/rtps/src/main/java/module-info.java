/// RTPS 2.5, the protocol of DDS, over UDP: finds participants on the network, and writes and reads samples of topics.
/// ROS 2 communicates by it. Knows bytes only: nothing of message types, robots or devices.
module rsal.rtps {
    requires static org.jspecify;

    exports rsal.rtps;
    exports rsal.rtps.discovery;
    exports rsal.rtps.wire;
}
