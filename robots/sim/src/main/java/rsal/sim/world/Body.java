package rsal.sim.world;

import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;

/// A robot or a thing as the world knows it: a figure with a name.
public final class Body {
    final Figure figure;
    final Figure trial; // where it might go
    final Figure seen; // where it was when sensors last looked
    final StallCache jam; // of the last way of which it could make nothing
    final int[] slots; // of its pieces, in the world's lists

    @Nullable
    Body carrier; // who took it along

    boolean hidden;

    private final String name;

    /// @param slots one for each solid
    Body(String name, List<CollisionShape> chunks, int[] slots) {
        this.name = name;
        this.slots = slots;
        figure = new Figure(chunks);
        trial = new Figure(chunks);
        seen = new Figure(chunks);
        jam = new StallCache(figure);
    }

    public String name() {
        return name;
    }

    /// Whether it is in the world: not [World#hide]den.
    public boolean isThere() {
        return !hidden;
    }

    /// Where it is: mapFromBase.
    public Pose2d pose() {
        return figure.pose();
    }

    /// Of its base above ground [m].
    public double height() {
        return figure.height();
    }

    /// The actuators that carry pieces of it.
    public List<String> carriers() {
        return figure.carriers();
    }

    /// Of a circle around its base that holds it as it is now [m].
    public double radius() {
        return figure.radius();
    }

    /// Where sensors see it: mapFromBase at the last [World#look].
    public Pose2d seenPose() {
        return seen.pose();
    }
}
