package rsal.ros2.health;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/// By which names a robot's programs speak of a device.
///
/// @param words in small letters, by which diagnostics call devices of its kind
/// @param nodes with a lifecycle that it needs, in the robot's namespace: of each list one
public record ReportNames(Set<String> words, List<List<String>> nodes) {
    /// Of a device that needs no node.
    public static ReportNames of(String... words) {
        return new ReportNames(Set.of(words), List.of());
    }

    /// The same, of a device that also needs one of these nodes.
    public ReportNames needing(String... either) {
        var all = new ArrayList<>(nodes);
        all.add(List.of(either));
        return new ReportNames(words, List.copyOf(all));
    }
}
