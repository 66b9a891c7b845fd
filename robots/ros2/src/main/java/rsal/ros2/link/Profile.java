package rsal.ros2.link;

/// How messages of a topic come: quality of service, as ROS 2 names its profiles.
public enum Profile {
    /// The newest matters, and what is lost is lost: best effort, volatile.
    SENSOR_DATA,

    /// All arrive: reliable, volatile.
    DEFAULT,

    /// All arrive, and those who come late get the last one: reliable, transient local.
    LATCHED
}
