package rsal.ros2.setting;

import java.time.Duration;

/// How robots are kept from moving when they should not.
///
/// @param watchdog after which a robot stops when nothing more is commanded
/// @param armed whether motors are on from the beginning
/// @param stopTopic in each robot's namespace: gets `std_msgs/Bool`, true while its motors are off; empty for none
/// @param stopService in each robot's namespace: `std_srvs/SetBool`, called with the same; empty for none
public record Safety(Duration watchdog, boolean armed, String stopTopic, String stopService) {}
