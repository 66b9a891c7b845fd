package rsal.server.frame;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.device.SimulationControl.Standing;
import rsal.server.description.AppearanceEncoder;
import rsal.server.message.Messages.ThingInfo;

/// Notes which things there are, and which are elsewhere than it was told. For one thread.
public final class ObjectTracker {
    /// More would not be seen on a screen, nor drawn in time.
    public static final int MOST_THINGS = 20_000;

    public static final int MOST_CORNERS = 200_000;

    private final int run;
    private final Map<Integer, Standing> reported = new HashMap<>(); // as they were when they were told
    private List<Standing> seen = List.of();
    private List<Standing> moved = List.of();
    private ObjectRegistry roster;
    private int newest; // number of a thing

    public ObjectTracker(int run) {
        this.run = run;
        roster = new ObjectRegistry(run, Map.of(), 0);
    }

    public void look(List<Standing> things) {
        if (things.equals(seen)) {
            return;
        }
        seen = things;
        int present = 0; // of those that were told
        int last = newest;
        var away = new ArrayList<Standing>();
        for (Standing thing : things) {
            last = Math.max(last, thing.number());
            Standing before = reported.get(thing.number());
            present += before == null ? 0 : 1;
            if (before != null && isElsewhere(before, thing)) {
                away.add(thing);
            }
        }
        moved = List.copyOf(away);
        if (last > newest || present < reported.size() || things.size() != reported.size() + roster.left()) {
            newest = last;
            publish(things);
        }
    }

    private void publish(List<Standing> things) {
        var all = new LinkedHashMap<Integer, ThingInfo>();
        var stay = new HashMap<Integer, Standing>();
        int corners = 0;
        for (Standing thing : things) {
            if (all.size() == MOST_THINGS || corners >= MOST_CORNERS) {
                break;
            }
            ThingInfo known = roster.all().get(thing.number());
            ThingInfo info = known == null ? AppearanceEncoder.thing(thing) : known;
            all.put(thing.number(), info);
            stay.put(thing.number(), reported.getOrDefault(thing.number(), thing));
            corners += ObjectRegistry.corners(info);
        }
        reported.clear();
        reported.putAll(stay);
        roster = new ObjectRegistry(run, all, things.size() - all.size());
    }

    private static boolean isElsewhere(Standing reported, Standing now) {
        return !now.mapFromThing().equals(reported.mapFromThing()) || now.height() != reported.height();
    }

    public ObjectRegistry roster() {
        return roster;
    }

    /// Those that are elsewhere than was told.
    public List<Standing> moved() {
        return moved;
    }
}
