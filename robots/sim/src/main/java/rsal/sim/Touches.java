package rsal.sim;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import rsal.device.SimulationControl.Contact;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// Who runs into what. A touch counts once, for the robot that began it, and is over when the two are a centimeter
/// apart.
final class Touches {
    private final List<Contact> contacts = new ArrayList<>();
    private final List<Touch> lasting = new ArrayList<>();
    private List<Contact> shown = List.of();

    private record Touch(Body robot, String other) {
        boolean joins(Body a, String b) {
            return (robot == a && other.equals(b)) || (robot.name().equals(b) && other.equals(a.name()));
        }
    }

    void ranInto(Body robot, String other, Instant now) {
        if (lasting.stream().noneMatch(touch -> touch.joins(robot, other))) {
            lasting.add(new Touch(robot, other));
            contacts.add(new Contact(now, robot.name(), other));
        }
    }

    /// Ends those touches that are over.
    void update(World world) {
        if (!lasting.isEmpty()) {
            lasting.removeIf(touch -> !world.touching(touch.robot(), touch.other()));
        }
    }

    List<Contact> contacts() {
        if (shown.size() < contacts.size()) {
            shown = List.copyOf(contacts);
        }
        return shown;
    }
}
