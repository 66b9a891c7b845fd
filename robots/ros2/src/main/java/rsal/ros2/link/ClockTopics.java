package rsal.ros2.link;

/// Topics by which programs share the time of a simulator.
public final class ClockTopics {
    private static final String TYPE = "rosgraph_msgs/msg/Clock";

    /// The simulator says its time.
    public static final RosTopic CLOCK = new RosTopic("/clock", TYPE);

    /// A program that follows says which time of `/clock` it has reached: it has done what was due by then, and sent
    /// its commands. Not of ROS, but of RSAL; any program may publish it.
    public static final RosTopic REACHED = new RosTopic("/clock_reached", TYPE);

    private ClockTopics() {}
}
