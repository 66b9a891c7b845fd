package rsal.sim;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.device.SimulationControl.Contact;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// Who runs into what. A touch counts once, for the robot that began it, and is over when the two are a centimeter
/// apart.
final class ContactTracker {
    private final List<Contact> contacts = new ArrayList<>();
    private final Set<Touch> lasting = new LinkedHashSet<>();
    private List<Contact> shown = List.of();

    /// @param other empty when it is a wall
    private record Touch(Body robot, Optional<Body> other) {
        Optional<Touch> fromTheOtherSide() {
            return other.map(body -> new Touch(body, Optional.of(robot)));
        }

        boolean lasts(World world) {
            return other.isPresent() ? world.touching(robot, other.get()) : world.touchingWall(robot);
        }
    }

    void ranInto(Body robot, Optional<Body> other, Instant now) {
        var touch = new Touch(robot, other);
        if (touch.fromTheOtherSide().filter(lasting::contains).isEmpty() && lasting.add(touch)) {
            contacts.add(new Contact(now, robot.name(), other.map(Body::name).orElse(World.WALL)));
        }
    }

    /// Ends those touches that are over.
    void update(World world) {
        if (!lasting.isEmpty()) {
            lasting.removeIf(touch -> !touch.lasts(world));
        }
    }

    /// A body is gone, and touches nothing any more.
    void forget(Body gone) {
        lasting.removeIf(touch ->
                touch.robot.equals(gone) || touch.other.filter(gone::equals).isPresent());
    }

    List<Contact> contacts() {
        if (shown.size() < contacts.size()) {
            shown = List.copyOf(contacts);
        }
        return shown;
    }
}
