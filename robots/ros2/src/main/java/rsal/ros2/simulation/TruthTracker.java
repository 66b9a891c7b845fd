package rsal.ros2.simulation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.SimulationControl;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Where entities of a simulated world are, and how fast they move: by how far they have come of late.
public final class TruthTracker {
    private static final Duration PERIOD = Duration.ofMillis(50);
    private static final int LOOKS = 5; // over 0.2 s, as worlds may move on by 0.1 s at a time
    private static final double JUMP = 20; // m/s, from which on something did not move there but was put there

    private final SimulationControl world;
    private final Scheduler scheduler;
    private final Task looking;
    private final Map<String, Deque<Look>> seen = new HashMap<>(); // the oldest first

    private record Look(Instant time, Pose2d pose) {}

    public TruthTracker(SimulationControl world, Scheduler scheduler) {
        this.world = world;
        this.scheduler = scheduler;
        looking = scheduler.every(PERIOD, Phase.OBSERVE, this::look);
    }

    private void look() {
        List<String> entities = world.entities();
        entities.forEach(entity -> world.truth(entity).ifPresent(pose -> look(entity, pose)));
        if (seen.size() > entities.size()) {
            seen.keySet().retainAll(new HashSet<>(entities));
        }
    }

    private void look(String entity, Pose2d pose) {
        Deque<Look> looks = seen.computeIfAbsent(entity, _ -> new ArrayDeque<>(LOOKS));
        if (!looks.isEmpty() && looks.getLast().pose.distanceTo(pose) > JUMP * PERIOD.toMillis() / 1e3) {
            looks.clear();
        }
        if (looks.size() == LOOKS) {
            looks.removeFirst();
        }
        looks.addLast(new Look(scheduler.instant(), pose));
    }

    /// Where something is now, in the map frame; empty when there is no such thing.
    public Optional<Pose2d> pose(String entity) {
        return world.truth(entity);
    }

    /// How fast it moves, in the axes of the map [m/s, rad/s]; at rest where that is not known.
    public Twist2d velocity(String entity) {
        Deque<Look> looks = seen.get(entity);
        if (looks == null || looks.size() < LOOKS) {
            return Twist2d.STOP;
        }
        Look first = looks.getFirst();
        Look last = looks.getLast();
        double seconds = Duration.between(first.time, last.time).toNanos() / 1e9;
        double turned = 0; // by all turns between, so that a fast one is none the other way round
        Pose2d before = first.pose;
        for (Look look : looks) {
            turned += Angles.wrap(look.pose.theta() - before.theta());
            before = look.pose;
        }
        return new Twist2d(
                (last.pose.x() - first.pose.x()) / seconds,
                (last.pose.y() - first.pose.y()) / seconds,
                turned / seconds);
    }

    /// Somebody put it elsewhere, where it is at rest.
    public void moved(String entity) {
        seen.remove(entity);
    }

    public void close() {
        looking.cancel();
    }
}
