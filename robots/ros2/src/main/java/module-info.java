/// ROS 2: its robots as robots of ours, and ours published to its programs and recorded. Knows nothing of agents,
/// scenarios or
/// navigation.
module rsal.ros2 {
    requires java.desktop; // ImageIO decodes compressed images
    requires rsal.devices;
    requires rsal.ros2.bags;
    requires rsal.ros2.messages;
    requires rsal.rtps;
    requires java.net.http;
    requires tools.jackson.core;
    requires tools.jackson.dataformat.cbor;
    requires static org.jspecify;

    provides rsal.system.BridgeProvider with
            rsal.ros2.bridge.Ros2BridgeProvider;
    provides rsal.system.RobotRecorderProvider with
            rsal.ros2.bridge.Ros2RecorderProvider;
    provides rsal.system.Diagnosis with
            rsal.ros2.system.Ros2Diagnosis;
    provides rsal.system.RobotSystemProvider with
            rsal.ros2.system.Ros2Provider;
}
