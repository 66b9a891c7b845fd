package rsal.sim.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.robot.Shift;

/// Pieces of a figure that actuators carry: a limb for each actuator that carries some.
final class ArticulatedBody {
    private final List<String> carriers; // of each limb
    private final PlacedShape[][] pieces; // of each limb
    private final Shift[] shifts; // of each limb, from where it is while all actuators are at home

    private ArticulatedBody(List<String> carriers, PlacedShape[][] pieces) {
        this.carriers = List.copyOf(carriers);
        this.pieces = pieces;
        this.shifts = new Shift[pieces.length];
        Arrays.fill(shifts, Shift.NONE);
    }

    /// @param pieces made of the chunks, in their order
    /// @return empty when no actuator carries any
    static Optional<ArticulatedBody> of(List<CollisionShape> chunks, PlacedShape[] pieces) {
        var carriers = new ArrayList<String>();
        var limbs = new ArrayList<List<PlacedShape>>();
        for (int i = 0; i < pieces.length; i++) {
            if (chunks.get(i) instanceof CollisionShape.Carried carried) {
                int limb = carriers.indexOf(carried.carrier());
                if (limb < 0) {
                    limb = carriers.size();
                    carriers.add(carried.carrier());
                    limbs.add(new ArrayList<>());
                }
                limbs.get(limb).add(pieces[i]);
            }
        }
        return limbs.isEmpty()
                ? Optional.empty()
                : Optional.of(new ArticulatedBody(
                        carriers,
                        limbs.stream()
                                .map(limb -> limb.toArray(PlacedShape[]::new))
                                .toArray(PlacedShape[][]::new)));
    }

    List<String> carriers() {
        return carriers;
    }

    /// @param others one for each limb
    void shift(List<Shift> others) {
        for (int i = 0; i < shifts.length; i++) {
            shifts[i] = others.get(i);
        }
    }

    /// Shifts them as those of a figure of the same make.
    void shift(ArticulatedBody others) {
        System.arraycopy(others.shifts, 0, shifts, 0, shifts.length);
    }

    /// Moves pieces that have been placed with the base to where actuators have carried them.
    ///
    /// @param height of the base above ground [m]
    void place(Pose2d mapFromBase, double height) {
        for (int i = 0; i < shifts.length; i++) {
            if (!shifts[i].isNone()) {
                Pose2d moved = mapFromBase.compose(shifts[i].baseFromMoved());
                double cos = StrictMath.cos(moved.theta());
                double sin = StrictMath.sin(moved.theta());
                for (PlacedShape piece : pieces[i]) {
                    piece.place(moved.x(), moved.y(), cos, sin, height + shifts[i].rise());
                }
            }
        }
    }

    /// Of a circle around the base that holds all of them where they are now [m].
    double radius(Pose2d mapFromBase) {
        double farthest = 0;
        for (PlacedShape[] limb : pieces) {
            for (PlacedShape piece : limb) {
                double distance = Math.hypot(piece.x() - mapFromBase.x(), piece.y() - mapFromBase.y());
                farthest = Math.max(farthest, distance + piece.radius());
            }
        }
        return farthest;
    }
}
