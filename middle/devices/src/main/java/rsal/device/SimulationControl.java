package rsal.device;

import java.util.List;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Solid;

/// Reads and changes the truth of a simulated world, which no real robot system can offer. For measuring and for
/// staging, not for robots to navigate by.
public interface SimulationControl extends Device {
    /// Names of the things that can be read and placed, robots among them.
    List<String> entities();

    /// Where a thing really is, in the map frame; empty when there is none of that name.
    Optional<Pose2d> truth(String entity);

    /// Puts a thing somewhere, standing still. Odometry does not notice.
    Placement place(String entity, Pose2d mapFromEntity);

    /// Puts a new thing into the world.
    default Placement add(Thing thing) {
        return new Placement.Refused("(%s) can't be added: this world takes no things.".formatted(thing.name()));
    }

    /// Takes a thing out of the world; a robot stays.
    ///
    /// @return whether there was such a thing
    default boolean remove(String thing) {
        return false;
    }

    /// Something that is no robot: a box, a ball, a marker, a charging station.
    ///
    /// @param name unique among the entities
    /// @param color of those pieces that have none
    /// @param obstacle whether robots run into it; else they drive through
    /// @param grippable whether grippers can hold it
    /// @param marker what fiducial finders see of it
    /// @param givingPower with which it charges each robot that touches it or stands on it [W]
    record Thing(
            String name,
            Pose2d mapFromThing,
            Solid body,
            Rgb color,
            boolean obstacle,
            boolean grippable,
            Optional<Marker> marker,
            double givingPower) {

        /// Something to look at, which is in nobody's way.
        public static Thing of(String name, Pose2d mapFromThing, Solid body, Rgb color) {
            return new Thing(name, mapFromThing, body, color, false, false, Optional.empty(), 0);
        }

        public Thing asObstacle() {
            return new Thing(name, mapFromThing, body, color, true, grippable, marker, givingPower);
        }

        public Thing asGrippable() {
            return new Thing(name, mapFromThing, body, color, obstacle, true, marker, givingPower);
        }

        public Thing with(Marker seen) {
            return new Thing(name, mapFromThing, body, color, obstacle, grippable, Optional.of(seen), givingPower);
        }

        public Thing giving(double power) {
            return new Thing(name, mapFromThing, body, color, obstacle, grippable, marker, power);
        }
    }

    /// @param id what is written on it
    /// @param key finders see only markers of their own key
    record Marker(int id, int key) {}

    sealed interface Placement {
        record Placed() implements Placement {}

        /// It stays where it was: a wall or something else is there, it is outside of the world, the pose is not
        /// finite, or nothing has that name.
        record Refused(String why) implements Placement {}
    }

    /// Collisions so far: how often a robot ran into something, each touch counted once until it is over.
    List<Contact> contacts();

    /// @param time when the touch began
    /// @param other the other robot or thing, or `wall`
    record Contact(java.time.Instant time, String robot, String other) {}
}
