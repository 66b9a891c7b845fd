package rsal.sim;

import java.time.Instant;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.RandomAccess;
import java.util.Set;
import rsal.device.SimulationControl.Contact;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// Who runs into what. A touch counts once, for the robot that began it, and is over when the two are a centimeter
/// apart.
final class ContactTracker {
    private static final int FEW = 16;

    private final Set<Touch> lasting = new LinkedHashSet<>();
    private Contact[] contacts = new Contact[FEW]; // the first of them are shared with those that were shown
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
            int count = shown.size();
            contacts = count < contacts.length ? contacts : Arrays.copyOf(contacts, 2 * count);
            contacts[count] =
                    new Contact(now, robot.name(), other.map(Body::name).orElse(World.WALL));
            shown = new First(contacts, count + 1);
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

    /// All until now. It stays as it is, and nothing is copied for it: runs may last for days.
    List<Contact> contacts() {
        return shown;
    }

    /// The first ones of an array, which do not change any more. Immutable.
    private static final class First extends AbstractList<Contact> implements RandomAccess {
        private final Contact[] all;
        private final int count;

        First(Contact[] all, int count) {
            this.all = all;
            this.count = count;
        }

        @Override
        public Contact get(int index) {
            return all[Objects.checkIndex(index, count)];
        }

        @Override
        public int size() {
            return count;
        }
    }
}
