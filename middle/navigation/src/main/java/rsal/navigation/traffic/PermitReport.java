package rsal.navigation.traffic;

import java.util.Map;

/// Who may enter the passages that it wants, as the planning robot says it to all. Also says that this robot is there.
///
/// @param number counts the reports of a robot; an older one that comes later does not count
/// @param permits ticket of the claim that has its passages, by the robot's id
/// @param waiting ticket of the claim that has to wait, by the robot's id
record PermitReport(long number, Map<String, Long> permits, Map<String, Long> waiting) {
    PermitReport {
        permits = Map.copyOf(permits);
        waiting = Map.copyOf(waiting);
    }
}
