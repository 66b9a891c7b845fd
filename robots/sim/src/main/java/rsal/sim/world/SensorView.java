package rsal.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;

/// The pieces of bodies as sensors see them: where they were when it was last [#look]ed, while bodies may move
/// on. Lists are by slot.
final class SensorView {
    private final List<@Nullable PlacedShape> pieces = new ArrayList<>();
    private final List<@Nullable Body> bodies = new ArrayList<>();
    private final List<@Nullable Body> owners = new ArrayList<>(); // of what is carried, who carries it
    private final PieceGrid grid;
    private final List<Body> moved = new ArrayList<>(); // since it was last looked
    private final List<Body> changed = new ArrayList<>(); // since then: came, was picked up or put down
    private final List<Body> gone = new ArrayList<>(); // since then
    private final IntConsumer freeSlot;
    private boolean watched;

    /// @param freeSlot takes slots that can be used again, as their piece is seen no more
    SensorView(Extent extent, IntConsumer freeSlot) {
        this.grid = new PieceGrid(extent);
        this.freeSlot = freeSlot;
    }

    /// Whether sensors look, maybe on other threads. What they see stays as it is meanwhile.
    void watched(boolean now) {
        watched = now;
    }

    void moved(Body body) {
        moved.add(body);
    }

    /// A body came, was picked up, or put down.
    void changed(Body body) {
        changed.add(body);
    }

    /// A body is in nobody's way any more.
    void hidden(Body body) {
        moved.removeIf(body::equals);
        changed.add(body);
        showUnlessWatched();
    }

    void gone(Body body) {
        moved.removeIf(body::equals);
        changed.removeIf(body::equals);
        gone.add(body);
        showUnlessWatched();
    }

    /// Who comes while sensors don't look is seen by the first that does.
    void showUnlessWatched() {
        if (!watched) {
            show();
        }
    }

    /// From now on bodies are seen where they are now. Not while it is [#watched].
    void look() {
        show();
        for (Body body : moved) {
            see(body);
        }
        moved.clear();
    }

    /// Lets sensors know who came, who is gone, and who belongs to whom.
    private void show() {
        for (Body body : gone) {
            unsee(body);
            for (int slot : body.slots) {
                freeSlot.accept(slot);
            }
        }
        gone.clear();
        for (Body body : changed) {
            if (body.hidden) {
                unsee(body);
                continue;
            }
            Body owner = body.carrier == null ? body : body.carrier;
            for (int i = 0; i < body.slots.length; i++) {
                while (pieces.size() <= body.slots[i]) {
                    pieces.add(null);
                    bodies.add(null);
                    owners.add(null);
                }
                pieces.set(body.slots[i], body.seen.pieces[i]);
                bodies.set(body.slots[i], body);
                owners.set(body.slots[i], owner);
            }
            see(body);
        }
        changed.clear();
    }

    private void unsee(Body body) {
        for (int slot : body.slots) {
            if (slot < pieces.size() && pieces.get(slot) != null) {
                grid.remove(slot);
                pieces.set(slot, null);
                bodies.set(slot, null);
                owners.set(slot, null);
            }
        }
    }

    private void see(Body body) {
        body.seen.placeAt(body.figure);
        World.enter(grid, body.slots, body.seen);
    }

    /// Finds the pieces that reach into a circle, where sensors see them.
    void near(double x, double y, double radius, PieceGrid.Found found) {
        grid.near(x, y, radius, found);
    }

    PlacedShape piece(int slot) {
        return Objects.requireNonNull(pieces.get(slot));
    }

    /// Whose piece sensors see there.
    Body body(int slot) {
        return Objects.requireNonNull(bodies.get(slot));
    }

    /// Whose piece sensors see there; of what is carried, who carries it.
    Body owner(int slot) {
        return Objects.requireNonNull(owners.get(slot));
    }
}
