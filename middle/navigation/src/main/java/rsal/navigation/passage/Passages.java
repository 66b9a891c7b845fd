package rsal.navigation.passage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;

/// The narrow passages of a map for robots of one size. Immutable; a pure function of the map and the size.
///
/// A cell is *wide* where a circle fits in which two robots pass each other. From the wide cells a wave runs over
/// all others where a robot can be. Where two parts of it meet that come from wide cells far apart is a *front*: the
/// middle of a door or a corridor. So doors of a single wall's thickness are found, which the opening of free space by
/// a disk (Serra 1982) covers from both sides, and also doors between two parts of one room. A passage consists of the
/// fronts, of cells deeper than corners of rooms are, and of the paths from these to the wide cells, which are its
/// gates.
/// The fronts are the points of the medial axis at which clearance is least (Thrun 1998, "critical points").
///
/// Limit: a connected part of the map without a wide place that a robot fits into has no passages. With a
/// body of 0.32 m, such are flats whose rooms are all below 2.2 m across, and floors that consist of
/// corridors only.
public final class Passages {
    private static final double ROOM = 0.1; // m between two robots that pass, and to walls
    private static final int MOST_ROUNDS = 3; // of widening passages whose gates nobody can wait at

    private final OccupancyGrid grid;
    private final int[] indices; // by cell; -1 outside of any
    private final List<Passage> all;
    private final List<Junction> junctions;

    private Passages(OccupancyGrid grid, int[] indices, List<Passage> all, List<Junction> junctions) {
        this.grid = grid;
        this.indices = indices;
        this.all = List.copyOf(all);
        this.junctions = List.copyOf(junctions);
    }

    /// Finds them.
    ///
    /// @param open where the middle of a robot can be
    /// @param toNotFree of the same map
    /// @param body radius of the circle that a robot turns in [m]
    public static Passages of(CostMap open, DistanceField toNotFree, double body) {
        toNotFree.checkIsOf(open.grid());
        var search = new PassageSearch(open, toNotFree, body, halfWidth(body));
        Passages found = search.find();
        for (int round = 1; round < MOST_ROUNDS && search.closeGatesWithoutRoom(found); round++) {
            found = search.find();
        }
        var junctions = new JunctionSearch(open, toNotFree, found.indices, body).find();
        return new Passages(found.grid, found.indices, found.all, junctions);
    }

    /// Half of the width from which on two robots can pass each other, even if they have to turn [m].
    public static double halfWidth(double body) {
        return 2 * body + 1.5 * ROOM;
    }

    static Passages of(OccupancyGrid grid, int[] indices, List<Passage> all) {
        return new Passages(grid, indices, all, List.of());
    }

    /// In no special order.
    public List<Passage> all() {
        return all;
    }

    /// Where wide corridors meet: outside of passages, the one with the most corridors and room first.
    public List<Junction> junctions() {
        return junctions;
    }

    /// The passage at a place in the map frame; empty outside of any.
    public Optional<Passage> at(Point2d mapFromPlace) {
        int index = index(mapFromPlace.x(), mapFromPlace.y());
        return index < 0 ? Optional.empty() : Optional.of(all.get(index));
    }

    /// The index of the passage at a place [m] in the map frame; -1 outside of any.
    public int index(double x, double y) {
        int column = grid.column(x);
        int row = grid.row(y);
        return grid.contains(column, row) ? indices[row * grid.width() + column] : -1;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Passages that
                && that.grid.equals(grid)
                && Arrays.equals(that.indices, indices)
                && that.all.equals(all)
                && that.junctions.equals(junctions);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(indices) + all.hashCode();
    }

    /// Which of these a path leads through, in its order, each time that it enters one.
    ///
    /// @param mapFromPath corners of the path
    public List<Crossing> crossings(List<Point2d> mapFromPath) {
        var crossings = new ArrayList<Crossing>();
        double done = 0;
        int inside = -1;
        double entered = 0;
        for (int leg = 1; leg < mapFromPath.size(); leg++) {
            Point2d from = mapFromPath.get(leg - 1);
            Point2d to = mapFromPath.get(leg);
            double length = from.distanceTo(to);
            int samples = Math.max(1, (int) Math.ceil(2 * length / grid.resolution()));
            for (int i = 0; i <= samples; i++) {
                double share = (double) i / samples;
                int now = index(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
                double at = done + share * length;
                if (now != inside) {
                    if (inside >= 0) {
                        crossings.add(new Crossing(all.get(inside), entered, at));
                    }
                    inside = now;
                    entered = at;
                }
            }
            done += length;
        }
        if (inside >= 0) {
            crossings.add(new Crossing(all.get(inside), entered, done));
        }
        return crossings;
    }

    /// Where a path leads through a passage.
    ///
    /// @param from length of path before it [m]
    /// @param to length of path to where it leaves it, or ends [m]
    public record Crossing(Passage passage, double from, double to) {}
}
