package rsal.device;

import java.util.List;
import java.util.Optional;
import rsal.data.Pose2d;

/// Reads and changes the truth of a simulated world, which no real robot system can offer. For measuring and for
/// staging, not for robots to navigate by.
public interface SimulationControl extends Device {
    /// Names of the things that can be read and placed, robots among them.
    List<String> entities();

    /// Where a thing really is, in the map frame; empty when there is none of that name.
    Optional<Pose2d> truth(String entity);

    /// Puts a thing somewhere, standing still. Odometry does not notice.
    Placement place(String entity, Pose2d mapFromEntity);

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
