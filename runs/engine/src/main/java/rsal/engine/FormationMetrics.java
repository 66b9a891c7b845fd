package rsal.engine;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.agent.message.FormationSlots;
import rsal.agent.message.FormationSlots.Slot;
import rsal.data.Pose2d;

/// Watches formations: where robots should be now, as who leads them said last, and for how long they were not yet in
/// place. Between two messages places move as the last one foretold.
final class FormationMetrics {
    private static final Duration FRESH = Duration.ofSeconds(2); // then nobody leads any more

    private final Map<String, Said> newest = new TreeMap<>(); // by leader
    private @Nullable Instant looked;
    private Duration forming = Duration.ZERO;

    private record Said(Instant time, FormationSlots ranks) {
        boolean isFresh(Instant now) {
            return !time.plus(FRESH).isBefore(now);
        }
    }

    void heard(String leader, FormationSlots ranks, Instant now) {
        newest.put(leader, new Said(now, ranks));
    }

    /// A step is over.
    void look(Instant now) {
        Instant before = looked;
        looked = now;
        if (before != null
                && newest.values().stream()
                        .anyMatch(
                                said -> said.isFresh(now) && !said.ranks.slots().isEmpty() && !said.ranks.formed())) {
            forming = forming.plus(Duration.between(before, now));
        }
    }

    /// Where a robot should be now; empty when it is in no formation, or this is not in place.
    Optional<Pose2d> mapFromSlot(String robot, Instant now) {
        for (Said said : newest.values()) {
            Slot slot = said.ranks.slots().get(robot);
            if (slot != null && said.isFresh(now) && said.ranks.formed()) {
                return Optional.of(FormationSlots.at(slot, Duration.between(said.time, now), said.ranks.ahead()));
            }
        }
        return Optional.empty();
    }

    /// For how long a formation was not in place so far.
    Duration forming() {
        return forming;
    }
}
