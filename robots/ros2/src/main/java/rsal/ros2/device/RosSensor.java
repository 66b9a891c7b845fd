package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SensorCore;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.tf.TransformLookup;

/// A device whose readings come as messages. When they stop coming, or nobody publishes them any more, its health says
/// so.
abstract class RosSensor<T> extends SensorCore<T> {
    private static final Duration PATIENCE = Duration.ofMillis(500); // of what comes more often
    private static final int MISSED = 3; // readings in a row

    private final String frame;
    private final String source;
    private Instant reported = Instant.MIN;
    private Duration period = Duration.ZERO; // the newest
    private String leftOut = ""; // why the newest message became no reading, for people; empty if it did

    /// @param frame of its readings
    /// @param source where they come from, for people
    RosSensor(DeviceInfo info, String frame, String source) {
        super(info);
        this.frame = frame;
        this.source = source;
    }

    /// A new reading; times go up, whatever the robot says.
    final void publish(Instant time, T value) {
        deliver(reading(time, value));
    }

    /// What would be the next reading.
    final Stamped<T> reading(Instant time, T value) {
        Instant after = latest().map(last -> last.time().plusNanos(1)).orElse(Instant.MIN);
        return new Stamped<>(time.isBefore(after) ? after : time, frame, value);
    }

    /// A message has come.
    final void heard(Instant now) {
        if (!reported.equals(Instant.MIN)) {
            period = Duration.between(reported, now);
        }
        reported = now;
        leftOut = "";
    }

    /// Where the sensor was on the robot when it measured: as TF says, or as the robot's model does where TF does not
    /// connect the two. Empty when TF has them for other times only: then the message is to be left out.
    ///
    /// @param sensor frame of the message
    /// @param stamp of the message [ns]
    /// @param usual of the model
    final Optional<FrameTransform> mount(Frames frames, String sensor, long stamp, FrameTransform usual) {
        TransformLookup baseFromSensor = frames.fromBase(sensor, stamp);
        if (baseFromSensor instanceof TransformLookup.Failure failure && baseFromSensor.isConnected()) {
            leaveOut(failure);
            return Optional.empty();
        }
        return Optional.of(baseFromSensor.transform().orElse(usual));
    }

    /// A message has come that can't be used.
    final void leaveOut(TransformLookup.Failure why) {
        leftOut = why.message();
    }

    /// Looks whether it is still told something.
    ///
    /// @param publishers how many publish it
    void look(Instant now, int publishers) {
        if (publishers == 0) {
            health(new Health.Lost("Nobody publishes %s.".formatted(source)));
            return;
        }
        Duration patience =
                PATIENCE.compareTo(period.multipliedBy(MISSED)) > 0 ? PATIENCE : period.multipliedBy(MISSED);
        boolean isSilent = hasReported() ? reported.plus(patience).isBefore(now) : !leftOut.isEmpty();
        if (isSilent) {
            health(new Health.Stale(
                    leftOut.isEmpty()
                            ? "Nothing has come on %s for more than %.1f s."
                                    .formatted(source, patience.toMillis() / 1e3)
                            : "What comes on %s is left out. %s".formatted(source, leftOut)));
        }
    }

    final boolean hasReported() {
        return !reported.equals(Instant.MIN);
    }
}
