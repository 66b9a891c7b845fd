package rsal.ros2.system;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.function.Consumer;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.link.ClockTopics;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;

/// The time of another simulator, as it publishes it on `/clock`, and how long it has stood still in real time.
final class SimulatorClock {
    private static final Logger LOG = System.getLogger(SimulatorClock.class.getName());
    private static final RosTopic TOPIC = ClockTopics.CLOCK;
    private static final Duration QUIET = Duration.ofSeconds(5); // of standing, before people learn of it

    private final RosLink link;
    private final String network;
    private final Subscribed subscribed;
    private final Publication reached;
    private final RosMessages messages = new RosMessages();
    private final Consumer<? super Instant> listener;
    private volatile long newest = -1; // [ns]; set on the link's thread
    private volatile boolean isHeard; // since the last look; also

    // of the run's thread
    private long seen = -1; // [ns]
    private Instant movedAt = Instant.MAX; // in real time
    private Instant heardAt = Instant.MAX; // in real time
    private Instant publishedAt = Instant.MAX; // in real time
    private boolean hasReported; // that it stands

    /// @param network for people: `domain 5`
    /// @param listener gets each new time, on a thread of the link
    SimulatorClock(RosLink link, String network, Consumer<? super Instant> listener) {
        this.link = link;
        this.network = network;
        this.listener = listener;
        reached = link.advertise(ClockTopics.REACHED, Profile.DEFAULT);
        subscribed = link.subscribe(TOPIC, Profile.SENSOR_DATA, this::take);
    }

    private void take(ByteBuffer bytes) {
        try {
            long now = RosMessages.stamp(CdrReader.of(bytes));
            if (now >= 0) {
                newest = now;
                isHeard = true;
                listener.accept(Instant.ofEpochSecond(0, now));
            }
        } catch (InvalidCdr _) {
            // a malformed message harms nobody
        }
    }

    /// Says to the simulator that the run has done what was due by a time, and has sent its commands.
    void reached(Instant time) {
        reached.publish(messages.clock(time));
    }

    boolean hasBegun() {
        return newest >= 0;
    }

    /// Looks whether time goes on.
    ///
    /// @param now in real time
    void look(Instant now) {
        long newestNow = newest;
        if (newestNow != seen || movedAt.equals(Instant.MAX)) {
            seen = newestNow;
            movedAt = now;
            hasReported = false;
        }
        if (isHeard || movedAt.equals(now)) {
            isHeard = false;
            heardAt = now;
        }
        boolean isPublished = movedAt.equals(now) || subscribed.publishers() > 0;
        if (isPublished || link.trouble().isPresent() || publishedAt.equals(Instant.MAX)) {
            publishedAt = now;
        }
        if (hasBegun() && !hasReported && standing(now).compareTo(QUIET) > 0) {
            hasReported = true;
            LOG.log(
                    Level.WARNING,
                    "No new time has come on /clock for {0} s: the run stands still. {1}",
                    QUIET.toSeconds(),
                    link.trouble().orElse("Maybe the simulator is paused?"));
        }
    }

    /// For how long it has stood still.
    ///
    /// @param now in real time
    Duration standing(Instant now) {
        return movedAt.isBefore(now) ? Duration.between(movedAt, now) : Duration.ZERO;
    }

    /// For how long no message has come, not even one of the same time.
    ///
    /// @param now in real time
    Duration silence(Instant now) {
        return heardAt.isBefore(now) ? Duration.between(heardAt, now) : Duration.ZERO;
    }

    /// For how long nobody has published it, since a new time came last, or what keeps the link from hearing others
    /// was over.
    ///
    /// @param now in real time
    Duration unpublished(Instant now) {
        return publishedAt.isBefore(now) ? Duration.between(publishedAt, now) : Duration.ZERO;
    }

    /// For people: why there is no time.
    String missing() {
        return subscribed.publishers() > 0
                ? "Somebody publishes '%s' in %s, but no time has come. Maybe the simulator is paused?"
                        .formatted(TOPIC.name(), network)
                : "Nobody publishes '%s' (%s) in %s, which 'useSimTime' needs. Start the simulator with its clock, or leave 'useSimTime' out."
                        .formatted(TOPIC.name(), TOPIC.type(), network);
    }
}
