package rsal.engine.metric;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rsal.device.SimulationControl.Standing;
import rsal.engine.event.EventLog;
import rsal.scenario.PlannedThings;
import rsal.scenario.PlannedThings.PlannedThing;

/// Knows which things lie in their depots, in truth: whatever agents say.
final class DepotMetrics {
    private static final double LIFTED = 0.01; // above the floor [m]; what is higher does not lie there

    private final EventLog eventLog;
    private final Map<String, PlannedThings> groups = new LinkedHashMap<>(); // those with a depot, by name of a thing
    private final Map<String, Integer> collected = new HashMap<>(); // by name of a group
    private final Set<String> ever = new HashSet<>(); // things that lay there

    DepotMetrics(List<PlannedThings> things, EventLog eventLog) {
        this.eventLog = eventLog;
        for (PlannedThings group : things) {
            if (group.depot().isPresent()) {
                for (PlannedThing each : group.each()) {
                    groups.put(each.thing().name(), group);
                }
            }
        }
    }

    /// Whether there is anything to look at.
    boolean areThere() {
        return !groups.isEmpty();
    }

    void look(List<Standing> things) {
        collected.clear();
        for (Standing thing : things) {
            PlannedThings group = groups.get(thing.name());
            if (group != null && thing.height() < LIFTED && isIn(group, thing)) {
                collected.merge(group.name(), 1, Integer::sum);
                if (ever.add(thing.name())) {
                    eventLog.event("collected", thing.name(), "lies in its depot");
                }
            }
        }
    }

    private static boolean isIn(PlannedThings group, Standing thing) {
        return group.depot()
                .filter(depot -> depot.holds(thing.mapFromThing().position(), 0))
                .isPresent();
    }

    /// How many of a group lie there.
    int collected(String group) {
        return collected.getOrDefault(group, 0);
    }
}
