package rsal.engine.world;

import java.time.Duration;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Thing;
import rsal.engine.event.EventLog;
import rsal.scenario.PlannedThings;
import rsal.scenario.PlannedThings.PlannedThing;
import rsal.scenario.RunPlan;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Puts the things of a plan into the simulated world when it is their time. Where something is in the way, they come
/// when it has gone.
public final class ThingArrivals {
    private static final Duration AGAIN = Duration.ofSeconds(1);

    private final RunPlan plan;
    private final Scheduler scheduler;
    private final EventLog eventLog;

    public ThingArrivals(RunPlan plan, Scheduler scheduler, EventLog eventLog) {
        this.plan = plan;
        this.scheduler = scheduler;
        this.eventLog = eventLog;
    }

    public void begin(SimulationControl simulation) {
        for (PlannedThings group : plan.things()) {
            for (PlannedThing each : group.each()) {
                if (each.comes().isZero()) {
                    put(simulation, each.thing(), true);
                } else {
                    scheduler.after(each.comes(), Phase.WORLD, () -> put(simulation, each.thing(), true));
                }
            }
        }
    }

    private void put(SimulationControl simulation, Thing thing, boolean first) {
        switch (simulation.add(thing)) {
            case Placement.Placed _ ->
                eventLog.event(
                        "thing",
                        thing.name(),
                        "is there, at " + thing.mapFromThing().rounded());
            case Placement.Refused(String why) -> {
                if (first) {
                    eventLog.event("thing", thing.name(), "can't come yet: " + why);
                }
                scheduler.after(AGAIN, Phase.WORLD, () -> put(simulation, thing, false));
            }
        }
    }
}
