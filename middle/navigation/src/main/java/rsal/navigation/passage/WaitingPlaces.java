package rsal.navigation.passage;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;

/// Finds places near a gate at which robots can wait without blocking it.
final class WaitingPlaces {
    private static final int MOST = 10;
    private static final int MOST_TRIED = 60;
    private static final double REACH = 3.5; // m around the gate
    private static final double ROOM = 0.1; // m between bodies
    private static final double TO_WALLS = 0.05; // m; who waits turns in place
    private static final double KEPT = 0.5; // share of the surroundings that a waiting robot leaves connected

    private final CostMap open;
    private final DistanceField toNotFree;
    private final OccupancyGrid grid;
    private final double body;
    private final int[] seen; // by cell, the number of the last flood that came there
    private int floods;

    /// @param body radius of the circle that a robot turns in [m]
    WaitingPlaces(CostMap open, DistanceField toNotFree, double body) {
        this.open = open;
        this.toNotFree = toNotFree;
        this.grid = open.grid();
        this.body = body;
        this.seen = new int[grid.cells().length];
    }

    /// @param gate a wide cell
    /// @param heading out of the passage [rad]
    /// @param passages by cell; -1 outside of any
    List<Point2d> near(int gate, double heading, int[] passages) {
        Point2d mapFromGate = grid.middle(gate);
        IntList around = flood(gate, passages, mapFromGate, 0);
        double apart = 2 * body + ROOM;
        List<Point2d> candidates = candidates(around, mapFromGate, apart);
        candidates.sort(Comparator.comparingDouble(place -> rank(place, mapFromGate, heading, apart)));
        var places = new ArrayList<Point2d>();
        int tried = 0;
        for (Point2d place : candidates) {
            if (places.size() == MOST || tried == MOST_TRIED) {
                break;
            }
            if (places.stream().allMatch(other -> other.distanceTo(place) >= apart)) {
                tried++;
                if (flood(gate, passages, place, apart).size() >= KEPT * around.size()) {
                    places.add(place);
                }
            }
        }
        return places;
    }

    private List<Point2d> candidates(IntList around, Point2d mapFromGate, double apart) {
        var candidates = new ArrayList<Point2d>();
        double least = body + TO_WALLS + grid.resolution() / 2;
        int every = Math.max(1, (int) (0.15 / grid.resolution()));
        for (int i = 0; i < around.size(); i++) {
            int cell = around.get(i);
            boolean onRaster = cell % grid.width() % every == 0 && cell / grid.width() % every == 0;
            Point2d place = grid.middle(cell);
            if (onRaster && toNotFree.at(cell) >= least && place.distanceTo(mapFromGate) >= apart) {
                candidates.add(place);
            }
        }
        return candidates;
    }

    /// Near and beside the way out is best; a place in the way out counts as 2 m farther.
    private static double rank(Point2d place, Point2d mapFromGate, double heading, double apart) {
        double x = place.x() - mapFromGate.x();
        double y = place.y() - mapFromGate.y();
        double lateral = Math.abs(-Math.sin(heading) * x + Math.cos(heading) * y);
        return Math.hypot(x, y) + 2 * Math.max(0, apart - lateral) / apart;
    }

    /// Cells to which a robot gets from the gate without passing near a place, outside of passages.
    private IntList flood(int gate, int[] passages, Point2d avoided, double by) {
        floods++;
        var cells = new IntList();
        cells.add(gate);
        seen[gate] = floods;
        Point2d middle = grid.middle(gate);
        for (int i = 0; i < cells.size(); i++) {
            int cell = cells.get(i);
            for (int next : new int[] {cell - 1, cell + 1, cell - grid.width(), cell + grid.width()}) {
                if (seen[next] != floods && open.isOpen(next) && passages[next] < 0) {
                    Point2d place = grid.middle(next);
                    if (place.distanceTo(middle) <= REACH && place.distanceTo(avoided) >= by) {
                        seen[next] = floods;
                        cells.add(next);
                    }
                }
            }
        }
        return cells;
    }
}
