package rsal.stage;

import java.util.List;
import java.util.function.Consumer;
import rsal.settings.Location;

/// A thing in a world: a robot, a sensor, a piece of furniture, the floor plan.
///
/// @param name unique in the world: `r0`, `r0.ranger:0`
/// @param macro what it was written as: `pioneer2dx`; its type when no macro was used
/// @param location where it is written; those made by a macro share it
/// @param parentFromModel its pose; z above the parent's top or, when that does not stack its children, above the
/// parent's underside [m]
/// @param worldFromModel where it is at first: its point of rotation in the plane, its underside in height
/// @param traits all else, shared by models of one make
public record StageModel(
        String name,
        String macro,
        Location location,
        Placement parentFromModel,
        Placement worldFromModel,
        Traits traits,
        List<StageModel> children) {

    public StageModel {
        children = List.copyOf(children);
    }

    /// This model, then all that belongs to it.
    public void forEach(Consumer<? super StageModel> action) {
        action.accept(this);
        children.forEach(child -> child.forEach(action));
    }
}
