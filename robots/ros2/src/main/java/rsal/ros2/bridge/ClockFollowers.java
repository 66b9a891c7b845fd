package rsal.ros2.bridge;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.LongSupplier;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.link.ClockTopics;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.RosMessages;
import rsal.system.Bridge.Pace;

/// Publishes the run's time on `/clock`, and says whether those who follow it have come as far.
///
/// A program that publishes `/clock_reached` has to have reached the newest time. Of all others, those that subscribe
/// to `/clock` as reliable may lack as many messages as are kept for them. One that stays behind for too long is
/// reported once, and waited for again when it has caught up. Of the run's thread.
final class ClockFollowers {
    /// Of real time. Loading a map or planning may take seconds on a busy machine.
    static final Duration PATIENCE = Duration.ofSeconds(10);

    /// Messages that reliable subscribers may lack: those of which they can still get all.
    static final int WINDOW = 9;

    private static final Logger LOG = System.getLogger(ClockFollowers.class.getName());
    private static final Duration AGAIN = Duration.ofMillis(50); // most subscribers are best effort
    private static final Duration LOOK = Duration.ofMillis(200); // for programs that have left
    private static final int MOST = 1_000; // programs

    private final RosLink link;
    private final LongSupplier real; // [ns]
    private final Runnable onArrival;
    private final Publication clock;
    private final Optional<Subscribed> reaching; // empty where they don't hold the run back
    private final Map<String, Long> reached = new ConcurrentHashMap<>(); // [ns] by publishers
    private final Set<String> tooSlow = new HashSet<>(); // are not waited for
    private final Set<String> reported = new HashSet<>();
    private final AtomicBoolean hasArrived = new AtomicBoolean(); // one, and the run has not looked since
    private long published = -1; // [ns]
    private byte[] message = {}; // that was published
    private long publishedAt; // in real time [ns]
    private long sentAt; // also
    private long lookedAt; // also
    private volatile boolean isAwaiting;

    /// @param isPaced whether they hold the run back
    /// @param real time [ns]
    /// @param onArrival called on a thread of the link when the run may perhaps go on
    ClockFollowers(RosLink link, boolean isPaced, LongSupplier real, Runnable onArrival) {
        this.link = link;
        this.real = real;
        this.onArrival = onArrival;
        clock = link.advertise(ClockTopics.CLOCK, Profile.DEFAULT);
        reaching = isPaced
                ? Optional.of(link.subscribeEach(ClockTopics.REACHED, Profile.DEFAULT, this::take))
                : Optional.empty();
    }

    private void take(String publisher, ByteBuffer bytes) {
        try {
            long time = RosMessages.stamp(CdrReader.of(bytes));
            if (reached.containsKey(publisher) || reached.size() < MOST) {
                reached.put(publisher, time);
            }
            if (isAwaiting && hasArrived.compareAndSet(false, true)) {
                onArrival.run();
            }
        } catch (InvalidCdr _) {
            // a malformed message harms nobody
        }
    }

    /// @param time [ns]
    /// @param bytes that say so
    void publish(long time, byte[] bytes) {
        published = time;
        message = bytes;
        publishedAt = real.getAsLong();
        sentAt = publishedAt;
        clock.publish(bytes);
    }

    /// The time begins again. Programs that follow say again what they have reached.
    void restart() {
        reached.clear();
        tooSlow.clear();
    }

    /// As [rsal.system.Bridge#pace].
    Pace pace() {
        if (reaching.isEmpty()) {
            return Pace.FREE;
        }
        hasArrived.set(false);
        long now = real.getAsLong();
        if (now - lookedAt >= LOOK.toNanos()) {
            lookedAt = now;
            reached.keySet().retainAll(reaching.get().publisherIds());
        }
        Map<String, Long> lacking = clock.unacknowledged();
        var behind = new HashSet<String>();
        reached.forEach((publisher, time) -> {
            if (time < published) {
                behind.add(publisher);
            }
        });
        lacking.forEach((subscriber, messages) -> {
            if (messages > WINDOW) {
                behind.add(subscriber);
            }
        });
        tooSlow.retainAll(behind);
        behind.removeAll(tooSlow);
        if (!behind.isEmpty() && now - publishedAt >= PATIENCE.toNanos()) {
            behind.forEach(this::giveUp);
            behind.clear();
        }
        isAwaiting = !behind.isEmpty();
        if (isAwaiting) {
            if (mayRepeat(behind, lacking)) {
                repeat(now);
            }
            return Pace.AWAITED;
        }
        return reached.size() + lacking.size() > tooSlow.size() ? Pace.FOLLOWED : Pace.UNFOLLOWED;
    }

    /// Those that acknowledge it do not need it again: it would only push out what is kept for them.
    private boolean mayRepeat(Set<String> behind, Map<String, Long> lacking) {
        return behind.stream().anyMatch(reached::containsKey)
                && lacking.entrySet().stream()
                        .allMatch(each -> each.getValue() < WINDOW || tooSlow.contains(each.getKey()));
    }

    /// The newest message may have been lost.
    private void repeat(long now) {
        if (now - sentAt >= AGAIN.toNanos()) {
            sentAt = now;
            clock.publish(message);
        }
    }

    private void giveUp(String follower) {
        tooSlow.add(follower);
        if (reported.size() < MOST && reported.add(follower)) {
            LOG.log(
                    Level.WARNING,
                    "{0} follows /clock, but has not reached {1} s within {2} s. The simulation no longer waits for it.",
                    link.program(follower),
                    published / 1e9,
                    PATIENCE.toSeconds());
        }
    }

    void close() {
        reaching.ifPresent(Subscribed::close);
        clock.close();
    }
}
