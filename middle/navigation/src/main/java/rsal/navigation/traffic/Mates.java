package rsal.navigation.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import rsal.data.Pose2d;

/// What a robot has heard of others, by id.
final class Mates {
    private static final double MOVED = 0.3; // m; less may be the localizer's

    private final TreeMap<String, Mate> all = new TreeMap<>();
    private long highest;

    /// One of them.
    static final class Mate {
        final String robot;
        TrafficReport report;
        Instant heardAt;
        private Pose2d movedTo;
        private Instant movedAt;

        private Mate(String robot, TrafficReport report, Instant now) {
            this.robot = robot;
            this.report = report;
            this.heardAt = now;
            this.movedTo = report.mapFromBase();
            this.movedAt = now;
        }

        /// For how long it has been where it is, or nobody has heard that it moved.
        Duration still(Instant now) {
            return Duration.between(movedAt, now);
        }
    }

    void heard(String robot, TrafficReport report, Instant now) {
        Mate mate = all.computeIfAbsent(robot, _ -> new Mate(robot, report, now));
        mate.heardAt = now;
        report.claim().ifPresent(claim -> highest = Math.max(highest, claim.ticket()));
        if (report.number() > mate.report.number()) {
            mate.report = report;
        }
        if (mate.movedTo.distanceTo(report.mapFromBase()) > MOVED) {
            mate.movedTo = report.mapFromBase();
            mate.movedAt = now;
        }
    }

    boolean isEmpty() {
        return all.isEmpty();
    }

    Collection<Mate> all() {
        return all.values();
    }

    /// Whether a robot says that it is done with a ticket.
    boolean isDone(String robot, long ticket) {
        Mate mate = all.get(robot);
        return mate != null && mate.report.done() >= ticket;
    }

    boolean isStill(String robot, Instant now, Duration time) {
        Mate mate = all.get(robot);
        return mate != null && mate.still(now).compareTo(time) > 0;
    }

    /// A ticket that comes after all that were heard.
    long next(Instant now) {
        return Math.max(now.toEpochMilli(), highest) + 1;
    }

    /// Newest ticket heard of each.
    Map<String, Long> heardTickets() {
        var tickets = new HashMap<String, Long>();
        all.forEach((robot, mate) -> mate.report.claim().ifPresent(claim -> tickets.put(robot, claim.ticket())));
        return tickets;
    }
}
