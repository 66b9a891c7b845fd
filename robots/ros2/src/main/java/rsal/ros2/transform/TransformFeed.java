package rsal.ros2.transform;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.tf.StampedTransform;
import rsal.ros2.tf.TransformBuffer;
import rsal.ros2.tf.TransformLookup;

/// Where frames are, as the topics `tf` and `tf_static` say, for all robots that share these.
public final class TransformFeed {
    private final TransformBuffer buffer = new TransformBuffer(TransformBuffer.HISTORY);
    private final Map<String, Instant> heard = new HashMap<>(); // when a moving frame's last transform came
    private final List<Runnable> listeners = new ArrayList<>();
    private final InstantSource clock;

    /// @param clock the run's
    TransformFeed(InstantSource clock) {
        this.clock = clock;
    }

    /// @param transforms of `tf`
    void add(RosMessage transforms) {
        for (StampedTransform each : StampedTransform.of(transforms)) {
            if (buffer.add(each)) {
                heard.put(each.child(), clock.instant());
            }
        }
        listeners.forEach(Runnable::run);
    }

    /// @param transforms of `tf_static`
    void addFixed(RosMessage transforms) {
        StampedTransform.of(transforms).forEach(buffer::addFixed);
    }

    /// Runs something after each message of frames that move.
    public void onTransforms(Runnable listener) {
        listeners.add(listener);
    }

    public TransformLookup find(String target, String source, long stamp) {
        return buffer.find(target, source, stamp);
    }

    /// For how long there has been no transform of the frame between two ones that is silent for longest; 0 where none
    /// of them moves.
    public Duration silence(String target, String source) {
        Instant now = clock.instant();
        return buffer.moving(target, source).stream()
                .map(frame -> Duration.between(Objects.requireNonNullElse(heard.get(frame), now), now))
                .max(Duration::compareTo)
                .orElse(Duration.ZERO);
    }

    /// Forgets where frames and all below them were, but not what never moves: their robot's time went back. Other
    /// robots may share the topics.
    public void clear(List<String> tops) {
        tops.forEach(top -> buffer.clear(top).forEach(heard::remove));
    }
}
