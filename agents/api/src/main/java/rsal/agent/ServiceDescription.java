package rsal.agent;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/// Something that an agent can do for others, as its entry in the directory says. What it costs here and now, it is
/// asked ([rsal.agent.protocol.Request]).
///
/// @param name as `gripper` or `collect`
/// @param details for people and for those who choose, as `reach` → `0.3 m`
public record ServiceDescription(String name, Map<String, String> details) {
    public ServiceDescription {
        if (name.isBlank()) {
            throw new IllegalArgumentException("A capability needs a name.");
        }
        details = Collections.unmodifiableMap(new TreeMap<>(details));
    }

    public static ServiceDescription of(String name) {
        return new ServiceDescription(name, Map.of());
    }
}
