package rsal.navigation.passage;

import java.util.List;
import rsal.data.Point2d;

/// A place in which two robots cannot pass each other: one direction at a time.
///
/// @param index among all of the map
/// @param mapFromMiddle a place in it, by which robots name it to each other
/// @param gates where it opens into wide places; one for a dead end
/// @param mapFromCells middles of the cells that it consists of
public record Passage(int index, Point2d mapFromMiddle, List<Gate> gates, List<Point2d> mapFromCells) {
    public Passage {
        gates = List.copyOf(gates);
        mapFromCells = List.copyOf(mapFromCells);
    }

    /// The gate that is nearest to a place.
    public Gate gateNear(Point2d mapFromPlace) {
        Gate nearest = gates.getFirst();
        for (Gate gate : gates) {
            if (gate.mapFromGate().distanceTo(mapFromPlace)
                    < nearest.mapFromGate().distanceTo(mapFromPlace)) {
                nearest = gate;
            }
        }
        return nearest;
    }

    /// Distance from a place to the nearest cell [m].
    public double distanceTo(Point2d mapFromPlace) {
        return nearest(mapFromPlace).distanceTo(mapFromPlace);
    }

    /// The cell that is nearest to a place.
    public Point2d nearest(Point2d mapFromPlace) {
        Point2d nearest = mapFromCells.getFirst();
        double least = Double.POSITIVE_INFINITY;
        for (Point2d cell : mapFromCells) {
            double x = cell.x() - mapFromPlace.x();
            double y = cell.y() - mapFromPlace.y();
            if (x * x + y * y < least) {
                least = x * x + y * y;
                nearest = cell;
            }
        }
        return nearest;
    }
}
