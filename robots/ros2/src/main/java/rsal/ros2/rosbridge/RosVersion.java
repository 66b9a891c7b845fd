package rsal.ros2.rosbridge;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/// Which ROS a server bridges. Names of types and of the parts of times differ.
enum RosVersion {
    ROS_1,
    ROS_2;

    private static final Pattern TYPE = Pattern.compile("([^/]+)/(msg|srv|action)/([^/]+)");
    private static final Pattern SHORT = Pattern.compile("([^/]+)/([^/]+)");
    private static final String TIME = "builtin_interfaces/msg/Time";
    private static final String DURATION = "builtin_interfaces/msg/Duration";

    /// By the names of the types that a server knows.
    static RosVersion of(List<String> types) {
        return types.stream().anyMatch(type -> TYPE.matcher(type).matches()) ? ROS_2 : ROS_1;
    }

    /// A type as the server names it: ROS 1 leaves out `msg`.
    ///
    /// @param type `sensor_msgs/msg/LaserScan`
    String wire(String type) {
        Matcher parts = TYPE.matcher(type);
        return this == ROS_1 && parts.matches() ? parts.group(1) + "/" + parts.group(3) : type;
    }

    /// A type of messages as ROS 2 names it.
    ///
    /// @param type as the server names it
    static String full(String type) {
        Matcher parts = SHORT.matcher(type);
        return parts.matches() ? parts.group(1) + "/msg/" + parts.group(2) : type;
    }

    /// A field as the server names it.
    ///
    /// @param type in which it is
    String wire(String type, String field) {
        boolean isTime = type.equals(TIME) || type.equals(DURATION);
        return this == ROS_1 && isTime ? other(field) : field;
    }

    /// What the other version calls a field: parts of times are `sec` and `nanosec` in ROS 2, `secs` and
    /// `nsecs` in ROS 1; the matrices of `CameraInfo` are `k` and `K`.
    static String other(String field) {
        return switch (field) {
            case "sec" -> "secs";
            case "nanosec" -> "nsecs";
            default -> field.length() == 1 ? field.toUpperCase(Locale.ROOT) : field;
        };
    }
}
