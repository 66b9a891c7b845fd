package rsal.sim.world;

import org.jspecify.annotations.Nullable;

/// Where a body got stuck. Who pushes on in the same way against what still stands there gets no farther, so that
/// nothing needs to be measured again: in a crowd that is what many robots do.
final class StallCache {
    private static final int NONE = -1;

    private final Figure stuck;
    private int place = NONE; // where the body was then: Figure.places
    private double forward;
    private double left;
    private double turn;
    private @Nullable Body obstacle; // null: a wall
    private int itsPlace;

    /// @param stuck of the body
    StallCache(Figure stuck) {
        this.stuck = stuck;
    }

    /// The body could make nothing of an arc.
    ///
    /// @param by what was in its way; null for a wall
    void begin(Arc arc, @Nullable Body by) {
        place = stuck.places();
        forward = arc.forward();
        left = arc.left();
        turn = arc.turn();
        obstacle = by;
        itsPlace = by == null ? NONE : by.figure.places();
    }

    /// Whether it can make nothing of an arc from where it is either.
    boolean holds(Arc arc) {
        return place == stuck.places()
                && forward == arc.forward()
                && left == arc.left()
                && turn == arc.turn()
                && (obstacle == null || itsPlace == obstacle.figure.places());
    }

    /// What is in its way; null for a wall.
    @Nullable
    Body obstacle() {
        return obstacle;
    }
}
