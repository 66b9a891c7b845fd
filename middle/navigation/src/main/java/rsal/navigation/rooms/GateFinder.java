package rsal.navigation.rooms;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// Finds the gates on the borders between regions: each connected piece of a border is one.
final class GateFinder {
    private final OccupancyGrid map;
    private final int[] regionOf;
    private final float[] halfWidths;
    private final double least;

    /// @param regionOf by cell
    /// @param halfWidths how far walls are from cells [m]
    /// @param least width of a gate [m]
    GateFinder(OccupancyGrid map, int[] regionOf, float[] halfWidths, double least) {
        this.map = map;
        this.regionOf = regionOf;
        this.halfWidths = halfWidths;
        this.least = least;
    }

    /// @return by the numbers of their regions
    List<RoomGate> gates() {
        var borders = new TreeMap<Long, List<Integer>>(); // cells of the region with the lower number, by pair
        for (int cell = 0; cell < regionOf.length; cell++) {
            if (isAtBorder(cell)) {
                for (int neighbor : neighbors(cell)) {
                    if (neighbor >= 0 && regionOf[neighbor] > regionOf[cell]) {
                        long pair = (long) regionOf[cell] << 32 | regionOf[neighbor];
                        List<Integer> border = borders.computeIfAbsent(pair, _ -> new ArrayList<>());
                        if (border.isEmpty() || border.getLast() != cell) {
                            border.add(cell);
                        }
                    }
                }
            }
        }
        var gates = new ArrayList<RoomGate>();
        borders.forEach((pair, border) -> {
            for (List<Integer> piece : pieces(border)) {
                RoomGate gate = gate(gates.size(), (int) (pair >>> 32), (int) (long) pair, piece);
                if (gate.width() >= least) {
                    gates.add(gate);
                }
            }
        });
        return List.copyOf(gates);
    }

    /// Whether the cell to the right, left, above or below is in a region with a greater number.
    private boolean isAtBorder(int cell) {
        int region = regionOf[cell];
        int column = cell % map.width();
        return region != RoomMap.NONE
                && ((column < map.width() - 1 && regionOf[cell + 1] > region)
                        || (column > 0 && regionOf[cell - 1] > region)
                        || (cell + map.width() < regionOf.length && regionOf[cell + map.width()] > region)
                        || (cell >= map.width() && regionOf[cell - map.width()] > region));
    }

    /// Right, left, up, down; -1 beyond the map.
    private int[] neighbors(int cell) {
        int column = cell % map.width();
        return new int[] {
            column < map.width() - 1 ? cell + 1 : -1,
            column > 0 ? cell - 1 : -1,
            cell + map.width() < regionOf.length ? cell + map.width() : -1,
            Math.max(-1, cell - map.width())
        };
    }

    /// Connected with at most one cell between, as borders are ragged.
    private List<List<Integer>> pieces(List<Integer> border) {
        var left = new TreeMap<Integer, Boolean>();
        border.forEach(cell -> left.put(cell, true));
        var pieces = new ArrayList<List<Integer>>();
        while (!left.isEmpty()) {
            var piece = new ArrayList<Integer>();
            piece.add(left.pollFirstEntry().getKey());
            for (int next = 0; next < piece.size(); next++) {
                int column = piece.get(next) % map.width();
                for (int rows = -2; rows <= 2; rows++) {
                    for (int columns = -2; columns <= 2; columns++) {
                        int cell = piece.get(next) + rows * map.width() + columns;
                        boolean isInRow = column + columns >= 0 && column + columns < map.width();
                        if (isInRow && left.remove(cell) != null) {
                            piece.add(cell);
                        }
                    }
                }
            }
            pieces.add(piece);
        }
        return pieces;
    }

    private RoomGate gate(int number, int one, int other, List<Integer> piece) {
        float most = -1;
        Point2d middle = map.middle(piece.getFirst());
        for (int cell : piece) {
            for (int neighbor : neighbors(cell)) {
                if (neighbor >= 0 && regionOf[neighbor] == other) {
                    float half = Math.min(halfWidths[cell], halfWidths[neighbor]);
                    if (half > most) {
                        most = half;
                        middle = between(map.middle(cell), map.middle(neighbor));
                    }
                }
            }
        }
        Point2d from = farthest(piece, middle);
        return new RoomGate(number, one, other, middle, 2 * most, from, farthest(piece, from));
    }

    private Point2d farthest(List<Integer> cells, Point2d place) {
        Point2d farthest = map.middle(cells.getFirst());
        for (int cell : cells) {
            Point2d middle = map.middle(cell);
            farthest = middle.distanceTo(place) > farthest.distanceTo(place) ? middle : farthest;
        }
        return farthest;
    }

    private static Point2d between(Point2d one, Point2d other) {
        return new Point2d((one.x() + other.x()) / 2, (one.y() + other.y()) / 2);
    }
}
