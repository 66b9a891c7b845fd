package rsal.ros2.type;

import java.util.Locale;

/// Distributions of ROS 2, whose definitions of some types differ. The oldest first.
public enum Distribution {
    HUMBLE,
    JAZZY,
    KILTED,
    LYRICAL;

    /// `jazzy`
    public String words() {
        return name().toLowerCase(Locale.ROOT);
    }
}
