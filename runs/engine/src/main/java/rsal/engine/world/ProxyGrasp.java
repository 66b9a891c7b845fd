package rsal.engine.world;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import rsal.data.GripperState;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Gripper;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Standing;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;

/// What becomes of simulated things when a real robot grips a real one: the nearest that can be gripped and lies
/// near enough is taken for the same, goes along with the robot's stand-in, and is put down where that one lets go.
/// Only what its gripper feels counts; what it was told to do, or wants, does not. All calls on the run's thread.
final class ProxyGrasp {
    private static final double REACH = 0.5; // [m]; by how far a robot may be wrong about where it is, and a bit
    private static final double LIFTED = 0.01; // [m]; what is higher does not lie on the floor

    private final RobotSpec spec;
    private final Predicate<String> taken;
    private final Consumer<String> reported;
    private boolean holding;
    private @Nullable String thing;

    /// @param taken whether a thing goes along with another
    /// @param reported what people see of it
    ProxyGrasp(RobotSpec spec, Predicate<String> taken, Consumer<String> reported) {
        this.spec = spec;
        this.taken = taken;
        this.reported = reported;
    }

    /// To be called again and again.
    ///
    /// @param mapFromBase where the stand-in is
    void follow(SimulationControl world, Gripper gripper, Pose2d mapFromBase) {
        Optional<GripperState> state = gripper.latest().map(Stamped::value);
        if (state.isEmpty() || !(spec.model().sensors().get(gripper.info().name()) instanceof Part.Gripper part)) {
            return;
        }
        Pose2d mapFromGripper = mapFromBase.compose(part.baseFromGripper());
        if (state.get().holding() && !holding) {
            holding = true;
            take(world, mapFromGripper);
        } else if (!state.get().holding() && holding) {
            letGo(world);
        }
        if (thing != null) {
            double raised = Double.isNaN(state.get().raised()) ? 0 : state.get().raised();
            world.placeAnyway(thing, mapFromGripper, raised * part.height());
        }
    }

    /// What goes along.
    Optional<String> thing() {
        return Optional.ofNullable(thing);
    }

    private void take(SimulationControl world, Pose2d mapFromGripper) {
        Optional<String> nearest = world.things().stream()
                .filter(one -> one.grippable() && one.height() < LIFTED && !taken.test(one.name()))
                .filter(one -> one.mapFromThing().distanceTo(mapFromGripper) < REACH)
                .min(Comparator.comparingDouble(one -> one.mapFromThing().distanceTo(mapFromGripper)))
                .map(Standing::name);
        thing = nearest.orElse(null);
        reported.accept(nearest.map("takes '%s' along"::formatted)
                .orElse("has gripped something that is not in the simulated world"));
    }

    /// Puts down what goes along, if anything.
    void letGo(SimulationControl world) {
        holding = false;
        if (thing != null) {
            String put = thing;
            thing = null;
            world.truth(put).ifPresent(there -> world.placeAnyway(put, there, 0));
            reported.accept("puts '%s' down".formatted(put));
        }
    }
}
