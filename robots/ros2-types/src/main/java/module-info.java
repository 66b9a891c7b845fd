/// Message types of ROS 2 as data: definitions, type hashes (RIHS01), and their bytes on the wire and in bags (CDR).
/// Knows nothing of networks, robots or devices.
module rsal.ros2.types {
    requires static org.jspecify;

    exports rsal.ros2.cdr;
    exports rsal.ros2.type;
}
