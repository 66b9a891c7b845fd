package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SensorCore;
import rsal.player.wire.Address;

/// A device that tells what it measures.
abstract class PlayerSensor<T> extends SensorCore<T> implements Remote {
    private static final Duration PATIENCE = Duration.ofSeconds(1);

    private final Address address;
    private final String frame;
    private boolean connected;
    private Instant reportedAt = Instant.MIN; // last, or since when it could; MIN before

    /// @param frame of its readings
    PlayerSensor(DeviceInfo info, Address address, String frame) {
        super(info);
        this.address = address;
        this.frame = frame;
    }

    /// What a message says; empty when it is none of its readings.
    abstract Optional<T> read(Record body);

    /// Whether something is wrong when it tells nothing for a second.
    boolean isSteady() {
        return true;
    }

    @Override
    public final Address address() {
        return address;
    }

    @Override
    public void take(Instant time, Record body) {
        read(body).ifPresent(value -> {
            heard(time);
            publish(time, value);
        });
    }

    /// The server has told something of it.
    final void heard(Instant time) {
        reportedAt = time;
    }

    /// A new reading; times go up, whatever the server says.
    final void publish(Instant time, T value) {
        Instant after = latest().map(last -> last.time().plusNanos(1)).orElse(Instant.MIN);
        deliver(new Stamped<>(time.isBefore(after) ? after : time, frame, value));
    }

    @Override
    public void connected() {
        connected = true;
        reportedAt = Instant.MIN;
        health(Health.ok());
    }

    @Override
    public void lost(String reason) {
        connected = false;
        health(new Health.Lost(reason));
    }

    @Override
    public void look(Instant now) {
        if (!connected || !isSteady()) {
            return;
        }
        if (reportedAt.equals(Instant.MIN)) {
            reportedAt = now;
        } else if (reportedAt.isBefore(now.minus(PATIENCE))) {
            health(new Health.Stale("No data for 1 s."));
        }
    }
}
