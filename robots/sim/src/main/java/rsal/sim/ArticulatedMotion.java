package rsal.sim;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// Moves what of a robot's body actuators carry, its limbs.
final class ArticulatedMotion {
    private final World world;
    private final Body body;
    private final List<DeviceMount> mounts;

    /// @param mounts that the limbs are on, in the order of the body's carriers
    ArticulatedMotion(World world, Body body, List<DeviceMount> mounts) {
        this.world = world;
        this.body = body;
        this.mounts = mounts;
    }

    /// Moves them until one would touch something.
    ///
    /// @param distance that any of their points makes, at most [m]
    /// @param actuator puts the actuator that moves where it is after a part of the way
    /// @return how much of the way they made, 0–1
    double move(double distance, DoubleConsumer actuator) {
        return world.bend(body, distance, part -> {
            actuator.accept(part);
            return mounts.stream().map(DeviceMount::now).toList();
        });
    }

    /// What was in their way last; empty when it was a wall.
    Optional<Body> obstacle() {
        return world.obstacle();
    }

    /// How far from the base they reach [m].
    double radius() {
        return body.radius();
    }
}
