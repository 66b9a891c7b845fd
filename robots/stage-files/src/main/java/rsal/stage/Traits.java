package rsal.stage;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/// What models of one make have in common: copies of a macro share it.
///
/// @param kind what it can do
/// @param size of the box that holds it
/// @param origin modelFromBody: where the middle of the box's underside is, seen from the point of rotation
/// @param body what is solid of it
/// @param color empty when it is to be drawn at random
/// @param mass [kg]
/// @param stacksChildren whether its children stand on top of it
/// @param alwaysOn whether it works though nobody asks
/// @param updateInterval between two readings; they are taken at the world's steps
/// @param controllers programs for Stage that would drive it
public record Traits(
        ModelKind kind,
        Size size,
        Placement origin,
        SolidBody body,
        Optional<StageColor> color,
        Returns returns,
        Energy energy,
        double mass,
        boolean stacksChildren,
        boolean alwaysOn,
        Duration updateInterval,
        List<Controller> controllers) {

    public Traits {
        controllers = List.copyOf(controllers);
    }

    /// What others notice of a model.
    ///
    /// @param obstacle whether robots run into it
    /// @param ranger reflectance, 1 is usual; rangers see through what has a negative one
    /// @param blob whether blob finders see it
    /// @param fiducial its id as a marker; 0 when it is none
    /// @param fiducialKey only finders of the same key see it
    /// @param gripper whether it can be gripped
    public record Returns(
            boolean obstacle, double ranger, boolean blob, int fiducial, int fiducialKey, boolean gripper) {}

    /// What a model holds, uses and exchanges.
    ///
    /// @param stored at first [J]; empty when it has no store, +∞ when it never runs dry
    /// @param capacity [J]; empty as above
    /// @param use while it works [W]; a base's grows with mass and speed, see [ModelKind.Position]
    /// @param give to models that touch it and take [W], at most
    /// @param take from models that touch it and give [W], at most
    public record Energy(OptionalDouble stored, OptionalDouble capacity, double use, double give, double take) {}

    /// A program that Stage would load.
    ///
    /// @param library `wander`
    /// @param arguments what follows it; may be empty
    public record Controller(String library, String arguments) {}
}
