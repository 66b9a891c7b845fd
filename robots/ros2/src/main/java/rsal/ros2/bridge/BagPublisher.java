package rsal.ros2.bridge;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher;
import rsal.ros2.link.RosTopic;
import rsal.ros2.record.BagWriter;
import rsal.ros2.record.OfferedQuality;

/// Topics go to a bag. What fails is kept, and ends the recording, not the run. Safe for several threads.
final class BagPublisher implements RosPublisher, AutoCloseable {
    private final BagWriter bag;
    private final LongSupplier clock;
    private final Map<RosTopic, Integer> topics = new HashMap<>(); // those of robots that come again are the same
    private @Nullable IOException failure;

    /// @param clock the run's time, at which messages come [ns]
    BagPublisher(BagWriter bag, LongSupplier clock) {
        this.bag = bag;
        this.clock = clock;
    }

    @Override
    public synchronized Publication advertise(RosTopic topic, Profile profile) {
        return new Publication() {
            @Override
            public void publish(byte[] message) {
                write(topic, profile, message);
            }

            @Override
            public void close() {
                // nothing is to be undone
            }
        };
    }

    /// Topics without any message are not in the bag.
    private synchronized void write(RosTopic topic, Profile profile, byte[] message) {
        if (failure != null) {
            return;
        }
        try {
            Integer number = topics.get(topic);
            if (number == null) {
                number = bag.topic(topic.name(), topic.type(), quality(profile));
                topics.put(topic, number);
            }
            bag.message(number, clock.getAsLong(), message);
        } catch (IOException e) {
            failure = e;
        } catch (RuntimeException e) { // as a file has 65,535 topics at most
            failure = new IOException(e.getMessage(), e);
        }
    }

    private static OfferedQuality quality(Profile profile) {
        return switch (profile) {
            case SENSOR_DATA -> OfferedQuality.BEST_EFFORT;
            case DEFAULT -> OfferedQuality.RELIABLE;
            case LATCHED -> OfferedQuality.LATCHED;
        };
    }

    synchronized Optional<IOException> failure() {
        return Optional.ofNullable(failure);
    }

    @Override
    public synchronized void close() {
        try {
            bag.close();
        } catch (IOException e) {
            failure = failure == null ? e : failure;
        }
    }
}
