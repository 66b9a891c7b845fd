package rsal.engine.world;

import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import rsal.data.Stamped;

/// Knows which robots were put elsewhere in the simulated world, so that nobody is shown what they sensed or believed
/// where they were before. All calls on the run's thread.
final class Relocations {
    private final Map<String, Placement> newest = new HashMap<>();

    /// @param believed done when its localizer believes to be there
    private record Placement(Instant time, CompletableFuture<Void> believed) {}

    void add(String robot, Instant time, CompletableFuture<Void> believed) {
        newest.put(robot, new Placement(time, believed));
    }

    /// Whether a robot sensed something where it is now.
    boolean isOfHere(String robot, Stamped<?> reading) {
        Placement placement = newest.get(robot);
        return placement == null || reading.time().isAfter(placement.time);
    }

    /// Whether a robot's belief is about where it is now, right or wrong.
    boolean isBeliefOfHere(String robot) {
        Placement placement = newest.get(robot);
        return placement == null || placement.believed.isDone();
    }
}
