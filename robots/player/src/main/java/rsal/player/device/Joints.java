package rsal.player.device;

import java.util.Optional;
import rsal.data.Interval;
import rsal.player.message.Actarray;

/// What an `actarray` says of its first joint.
final class Joints {
    private Joints() {}

    /// Of its position [m or rad]; empty when the message does not tell, or nothing that can be.
    static Optional<Interval> limits(Record body) {
        if (!(body instanceof Actarray.Geometry geometry) || geometry.joints().isEmpty()) {
            return Optional.empty();
        }
        Actarray.JointGeometry joint = geometry.joints().getFirst();
        return joint.max() > joint.min() ? Optional.of(new Interval(joint.min(), joint.max())) : Optional.empty();
    }

    /// How it is; empty when the message does not tell, or no number.
    static Optional<Actarray.Joint> first(Record body) {
        return body instanceof Actarray.State state
                ? state.joints().stream()
                        .limit(1)
                        .filter(joint -> Float.isFinite(joint.position()))
                        .findFirst()
                : Optional.empty();
    }
}
