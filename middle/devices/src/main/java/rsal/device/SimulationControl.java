package rsal.device;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.data.Fan;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Solid;

/// Reads and changes the true state of a simulated world. Real robot systems do not have it. It is for metrics
/// and for preparing worlds, not for navigation.
public interface SimulationControl extends Device {
    /// Names of the things that can be read and placed, robots among them.
    List<String> entities();

    /// The true pose of a thing, in the map frame; empty if there is none of that name.
    Optional<Pose2d> truth(String entity);

    /// Moves a thing to a pose, at which it stands still. Odometry does not notice.
    Placement place(String entity, Pose2d mapFromEntity);

    /// As [#place], but also at an occupied pose. It is for proxies of real robots, whose real poses may be
    /// occupied in the simulated world. A robot that overlaps the proxy can only drive out of it.
    default Placement placeAnyway(String entity, Pose2d mapFromEntity) {
        return place(entity, mapFromEntity);
    }

    /// As [#placeAnyway], at a height: for a thing that a real robot carries.
    ///
    /// @param height of its underside above the floor [m]
    default Placement placeAnyway(String thing, Pose2d mapFromThing, double height) {
        return placeAnyway(thing, mapFromThing);
    }

    /// Adds a new thing to the world.
    default Placement add(Thing thing) {
        return new Placement.Refused(
                "'%s' can't be added: things can't be added to this world.".formatted(thing.name()));
    }

    /// As [#add], but also at an occupied pose.
    default Placement addAnyway(Thing thing) {
        return add(thing);
    }

    /// Removes a thing from the world; robots are not removed.
    ///
    /// @return whether there was such a thing
    default boolean remove(String thing) {
        return false;
    }

    /// All things except robots, as they are now, in the order in which they were added.
    default List<Standing> things() {
        return List.of();
    }

    /// The solid pieces of a thing or a robot, in its own frame, with their colors, the lowest first; empty if
    /// there is none of that name, or nothing is solid. Of a robot, as it is while its actuators are at home.
    default Optional<Solid> body(String entity) {
        return Optional.empty();
    }

    /// The devices and pieces of a robot that actuators have moved from their home positions.
    default List<Carried> carried(String robot) {
        return List.of();
    }

    /// The lengths of rays up to the first robot or thing that range sensors see [m], one fan after the other;
    /// +∞ for a ray that hits nothing. They are those at the last measurement. They pass through walls. For
    /// robots that are elsewhere to see what is here.
    ///
    /// @param mapFromBase of the one that looks
    /// @param height of the rays above the floor [m]
    /// @param reach how far they go [m]
    /// @param through names of those that they pass through
    default double[] ranges(List<Fan> fans, Pose2d mapFromBase, double height, double reach, Set<String> through) {
        var ranges = new double[fans.stream().mapToInt(Fan::count).sum()];
        Arrays.fill(ranges, Double.POSITIVE_INFINITY);
        return ranges;
    }

    /// Adds a robot with the model, role, color and body of another robot, and with its own devices. The robot
    /// system reports that it was added.
    ///
    /// @param id unique among the entities
    /// @param like id of a robot that is there or was
    default Placement addRobot(String id, String like, Pose2d mapFromBase) {
        return new Placement.Refused("'%s' can't be added: robots can't be added to this world.".formatted(id));
    }

    /// Takes a robot out of the world. It lets go of what it holds, its devices are lost, and the robot system tells
    /// that it was removed.
    ///
    /// @return whether there was such a robot
    default boolean removeRobot(String id) {
        return false;
    }

    /// A thing that is somewhere. As long as it is not moved, it is the same object.
    ///
    /// @param number from 1, of no other thing that there is or was
    /// @param body in its own frame, each piece in its color
    /// @param height of its underside above the floor [m]
    /// @param grippable whether grippers can hold it
    record Standing(int number, String name, Solid body, Pose2d mapFromThing, double height, boolean grippable) {}

    /// What stands on one actuator of a robot.
    ///
    /// @param devices by name
    /// @param pieces of its [#body], by number from 0
    /// @param baseFromMoved where the base would be if all of the robot had moved like that
    /// @param rise the same, upwards [m]
    record Carried(List<String> devices, List<Integer> pieces, Pose2d baseFromMoved, double rise) {}

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
        /// It is there now.
        record Placed() implements Placement {}

        /// It stays where it was: a wall or something else is there, it is outside of the world, the pose is not
        /// finite, or nothing has that name.
        record Refused(String why) implements Placement {}
    }

    /// Collisions so far; each contact counts once until it ends.
    List<Contact> contacts();

    /// A robot has touched something.
    ///
    /// @param time when the touch began
    /// @param other the other robot or thing, or `wall`
    record Contact(java.time.Instant time, String robot, String other) {}
}
