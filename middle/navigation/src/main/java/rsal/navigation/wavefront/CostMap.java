package rsal.navigation.wavefront;

import java.util.List;
import java.util.function.IntConsumer;
import java.util.function.IntPredicate;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.CellWindow;
import rsal.navigation.grid.Difference;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.MapOverlay;

/// Where the middle of a robot may be on a map, and how dear it is to be there. Immutable; robots of the same
/// size that share a map share it.
public final class CostMap {
    /// Cost of crossing a cell far from everything, along a side of it.
    static final int STRAIGHT = 10;

    /// Cost of a step along a side, far from everything.
    static final int SIDE = 2 * STRAIGHT;

    /// Most a cell can cost.
    static final int DEAREST = 60;

    /// Of [#ground]: where the robot can't be.
    static final byte BLOCKED = 0;

    private static final int COST = 63; // the bits of a cell's cost
    private static final int AROUND = 64; // the bit for that all around costs as little

    /// Of [#ground]: a cell that costs no more than [#STRAIGHT], like all eight around it.
    static final byte PLAIN = AROUND | STRAIGHT;

    private static final int DEAREST_SHOWN = 99; // of OccupancyGrid's values, below that of what is occupied

    private final OccupancyGrid grid;
    private final Clearance clearance;
    private final boolean driven; // whether some of it is open as robots have been there
    private final byte[] ground;
    private final int[] shore;
    private volatile @Nullable OccupancyGrid shown;

    /// What distances from walls cost.
    ///
    /// @param radius nearer than this the robot's middle never comes to an obstacle or the unknown [m]
    /// @param comfort from here on nearness costs nothing [m]
    /// @param weight how many times dearer a way at `radius` is than one beyond `comfort`, less one; 0–5
    public record Clearance(double radius, double comfort, double weight) {
        public Clearance {
            if (!(radius >= 0
                    && comfort >= radius
                    && comfort < Double.POSITIVE_INFINITY
                    && weight >= 0
                    && weight <= 5)) {
                throw new IllegalArgumentException(
                        "A clearance needs 0 ≤ radius '%s' ≤ comfort '%s' < ∞ and 0 ≤ weight '%s' ≤ 5."
                                .formatted(radius, comfort, weight));
            }
        }

        /// Costs rise with the square of what is missing to comfort.
        ///
        /// @param distance no less than `radius` [m]
        int cost(double distance) {
            if (distance >= comfort) {
                return STRAIGHT; // most are, and what follows takes longer
            }
            double missing = (comfort - distance) / (comfort - radius);
            return (int) Math.round(STRAIGHT * (1 + weight * missing * missing));
        }
    }

    private CostMap(OccupancyGrid grid, Clearance clearance, boolean driven, byte[] ground, int[] shore) {
        this.grid = grid;
        this.clearance = clearance;
        this.driven = driven;
        this.ground = ground;
        this.shore = shore;
    }

    /// The outermost cells of the map are blocked: nobody knows what lies beyond.
    public static CostMap of(OccupancyGrid grid, DistanceField toNotFree, Clearance clearance) {
        return of(grid, toNotFree, clearance, List.of());
    }

    /// The same where robots have been, which can go there again, however narrow the map has become: free cells along
    /// their ways are open, and as dear as those nearest to walls.
    ///
    /// @param driven places where each of them was, one after the other [m]
    public static CostMap of(
            OccupancyGrid grid, DistanceField toNotFree, Clearance clearance, List<List<Point2d>> driven) {
        byte[] ground = CostComputation.all(grid, toNotFree, clearance, driven);
        return new CostMap(grid, clearance, !driven.isEmpty(), ground, FreeSpaceBoundary.of(grid, ground));
    }

    /// The same over a map that has changed, as [#of] computes it where nobody has been: taken over, and computed again
    /// only as near to what differs as costs reach.
    ///
    /// @param difference of that map from this one's
    /// @param toNotFree of that map
    public CostMap over(Difference difference, DistanceField toNotFree) {
        OccupancyGrid next = difference.now();
        checkIsFromThis(difference);
        toNotFree.checkIsOf(next);
        double farthest = clearance.comfort() / next.resolution() + 2; // from middle to middle, and rounding
        int reach = (int) Math.min(farthest, next.width() + next.height());
        CellWindow all = CellWindow.of(next);
        List<CellWindow> windows = difference.windows().stream()
                .map(window -> window.grown(reach).within(all))
                .filter(window -> !window.isEmpty())
                .toList();
        if (driven || windows.stream().mapToLong(CellWindow::area).sum() > Difference.most(next)) {
            return of(next, toNotFree, clearance);
        }
        MapOverlay overlay = difference.overlay();
        byte[] nextGround = overlay.moved(ground);
        CostComputation.within(windows, next, toNotFree, clearance, nextGround);
        return new CostMap(
                next, clearance, false, nextGround, FreeSpaceBoundary.over(overlay, shore, nextGround, windows));
    }

    private void checkIsFromThis(Difference difference) {
        OccupancyGrid before = difference.overlay().before();
        if (MapOverlay.of(before, grid).filter(MapOverlay::isSameSize).isEmpty()) {
            throw new IllegalArgumentException("""
                    Costs of a map of %d × %d cells of %s m from (%s, %s) are not taken over by a difference from one of \
                    %d × %d cells of %s m from (%s, %s).
                    Maybe it is the one from a map before, or after.""".formatted(
                            grid.width(),
                            grid.height(),
                            grid.resolution(),
                            grid.originX(),
                            grid.originY(),
                            before.width(),
                            before.height(),
                            before.resolution(),
                            before.originX(),
                            before.originY()));
        }
    }

    /// Does something with each cell that the robot can't be in because of an obstacle that is not on the map [m].
    public void around(Point2d obstacle, IntConsumer cells) {
        int column = grid.column(obstacle.x());
        int row = grid.row(obstacle.y());
        double radius = clearance.radius();
        int reach = (int) Math.ceil(radius / grid.resolution());
        double square = radius * radius / (grid.resolution() * grid.resolution());
        for (int dy = -reach; dy <= reach; dy++) {
            for (int dx = -reach; dx <= reach; dx++) {
                if (dx * dx + dy * dy <= square && grid.contains(column + dx, row + dy)) {
                    cells.accept((row + dy) * grid.width() + column + dx);
                }
            }
        }
    }

    public OccupancyGrid grid() {
        return grid;
    }

    /// The same for people, as [rsal.device.Navigator#costMap] has it, on a scale to the dearest place of this
    /// map. Made when somebody first asks.
    public OccupancyGrid shown() {
        OccupancyGrid made = shown;
        if (made == null) {
            made = new OccupancyGrid(
                    grid.width(), grid.height(), grid.resolution(), grid.originX(), grid.originY(), shownCells());
            shown = made;
        }
        return made;
    }

    private byte[] shownCells() {
        int dearest = STRAIGHT + 1; // where nothing is dear, nothing is shown as such
        for (byte one : ground) {
            dearest = Math.max(dearest, cost(one));
        }
        var cells = new byte[ground.length];
        for (int cell = 0; cell < cells.length; cell++) {
            if (grid.cells()[cell] == OccupancyGrid.UNKNOWN) {
                cells[cell] = OccupancyGrid.UNKNOWN;
            } else if (ground[cell] == BLOCKED) {
                cells[cell] = OccupancyGrid.OCCUPIED;
            } else {
                cells[cell] = (byte) (DEAREST_SHOWN * (cost(ground[cell]) - STRAIGHT) / (dearest - STRAIGHT));
            }
        }
        return cells;
    }

    /// What the cells are like, row by row: [#BLOCKED], [#PLAIN] or, of what [#cost] tells, [#STRAIGHT] to [#DEAREST].
    /// All in one, as waves look at little else. Not to be written to.
    byte[] ground() {
        return ground;
    }

    /// What a cell with such ground costs.
    static int cost(byte ground) {
        return ground & COST;
    }

    /// Which cells are [#BLOCKED] beside an open one or across a corner from it, in ascending order. Not to be written
    /// to.
    int[] shore() {
        return shore;
    }

    /// Whether the robot may be in the middle of a cell.
    public boolean isOpen(int cell) {
        return ground[cell] != BLOCKED;
    }

    /// What a diagonal step costs where one along a side would cost so much.
    static int diagonal(int side) {
        return (side * 181) >> 7; // √2 within 0.02 %
    }

    /// What a step from a cell to one of its neighbors costs, there or back: half of each is crossed. Where nothing
    /// is near it is [#SIDE].
    int step(int from, int to, boolean diagonally) {
        int side = cost(ground[from]) + cost(ground[to]);
        return diagonally ? diagonal(side) : side;
    }

    /// Whether the robot may be at a place in the map frame.
    public boolean isPassable(Point2d place) {
        int column = grid.column(place.x());
        int row = grid.row(place.y());
        return grid.contains(column, row) && isOpen(row * grid.width() + column);
    }

    /// What going straight from one place to another costs, in meters of undisturbed way; +∞ when it is blocked.
    public double straightCost(Point2d from, Point2d to) {
        return straightCost(from, to, this::isOpen);
    }

    /// The same where other cells are open.
    double straightCost(Point2d from, Point2d to, IntPredicate isOpen) {
        double length = from.distanceTo(to);
        int samples = Math.max(1, (int) Math.ceil(2 * length / grid.resolution()));
        long sum = 0;
        for (int i = 0; i <= samples; i++) {
            double share = (double) i / samples;
            int column = grid.column(from.x() + share * (to.x() - from.x()));
            int row = grid.row(from.y() + share * (to.y() - from.y()));
            int cell = row * grid.width() + column;
            if (!grid.contains(column, row) || !isOpen.test(cell)) {
                return Double.POSITIVE_INFINITY;
            }
            sum += cost(ground[cell]);
        }
        return length * sum / (samples + 1) / STRAIGHT;
    }
}
