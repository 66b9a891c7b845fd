package rsal.scene;

import java.util.Optional;
import rsal.data.Prism;

/// A piece of a body with what others make of it.
///
/// @param prism in the body's frame, while all actuators are at home; its own color counts no more
/// @param carrier the actuator of a robot that it moves with, by the device's name
public record Block(Prism prism, Surface surface, Optional<String> carrier) {
    /// One that moves with its body.
    public Block(Prism prism, Surface surface) {
        this(prism, surface, Optional.empty());
    }

    /// The same, of which others make something else.
    public Block with(Surface other) {
        return new Block(prism, other, carrier);
    }
}
