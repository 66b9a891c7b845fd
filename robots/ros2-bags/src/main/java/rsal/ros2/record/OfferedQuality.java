package rsal.ros2.record;

/// With which quality of service the messages of a topic were published, so that players offer the same.
public enum OfferedQuality {
    /// What is lost is lost, as of sensors.
    BEST_EFFORT("best_effort", "volatile", 10),

    /// All arrive.
    RELIABLE("reliable", "volatile", 10),

    /// All arrive, and those who come late get the last one.
    LATCHED("reliable", "transient_local", 1);

    private static final String FOREVER = "{sec: 9223372036, nsec: 854775807}";

    private final String reliability;
    private final String durability;
    private final int depth;

    OfferedQuality(String reliability, String durability, int depth) {
        this.reliability = reliability;
        this.durability = durability;
        this.depth = depth;
    }

    /// A list of one profile in YAML, as version 9 of `metadata.yaml` has it.
    ///
    /// @param indent spaces before each line
    String yaml(int indent) {
        return """
                - history: keep_last
                  depth: %d
                  reliability: %s
                  durability: %s
                  deadline: %s
                  lifespan: %s
                  liveliness: automatic
                  liveliness_lease_duration: %s
                  avoid_ros_namespace_conventions: false
                """.formatted(depth, reliability, durability, FOREVER, FOREVER, FOREVER)
                .indent(indent);
    }
}
