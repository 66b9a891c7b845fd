package rsal.behavior;

import rsal.data.Twist2d;

/// Wants the same all the time: driving by hand, spinning on the spot. Layers above it make it safe.
public record SetSpeed(Twist2d twist) implements Behavior {
    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        return twist;
    }
}
