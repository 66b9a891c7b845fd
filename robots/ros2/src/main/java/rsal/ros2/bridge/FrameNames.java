package rsal.ros2.bridge;

/// Which frames (REP 105) a robot's messages are in.
///
/// @param prefix of its own frames: `robot1/`, or empty where each robot has topics of its own for transforms
record FrameNames(String prefix) {
    static final FrameNames PLAIN = new FrameNames("");

    private static final String MAP = "map";

    /// That of all robots.
    String map() {
        return MAP;
    }

    String odom() {
        return prefix + "odom";
    }

    String base() {
        return prefix + "base_link";
    }

    String sensor(String name) {
        return prefix + name;
    }

    /// That of a camera with its z axis ahead (REP 103).
    String optical(String name) {
        return prefix + name + "_optical_frame";
    }
}
