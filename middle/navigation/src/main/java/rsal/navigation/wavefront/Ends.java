package rsal.navigation.wavefront;

import java.util.Locale;
import java.util.function.IntPredicate;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// Between which cells of a map a way leads.
public sealed interface Ends {
    /// Those of its start and goal, or the nearest ones where the robot can be.
    record Cells(int start, int goal) implements Ends {}

    record None(Plan.None why) implements Ends {}

    double ESCAPE = 1.0; // m; so far a robot may have got where it may not be
    double LOOK_AROUND = 5; // m; for a place to name instead of a goal

    /// @param slack how far from the goal a way may end when the robot can't be there [m]
    static Ends of(CostMap map, Point2d start, Point2d goal, double slack) {
        return of(map, start, goal, slack, map::isOpen);
    }

    /// @param isOpen in which cells the robot can be
    static Ends of(CostMap map, Point2d start, Point2d goal, double slack, IntPredicate isOpen) {
        OccupancyGrid grid = map.grid();
        if (!grid.contains(grid.column(goal.x()), grid.row(goal.y()))) {
            return none("The goal %s is outside the map.", goal);
        }
        if (!grid.contains(grid.column(start.x()), grid.row(start.y()))) {
            return none("The start %s is outside the map.", start);
        }
        int goalCell = nearest(grid, goal, slack, isOpen);
        if (goalCell < 0) {
            return none("The goal %s is " + whyNot(grid, goal, isOpen), goal);
        }
        int startCell = nearest(grid, start, ESCAPE, isOpen);
        if (startCell < 0) {
            return none("The robot at %s is enclosed by obstacles.", start);
        }
        return new Cells(startCell, goalCell);
    }

    /// No way leads from its start to its goal.
    static Plan.None apart(Point2d goal) {
        return new Plan.None("No path that is wide enough for this robot leads to the goal %s.".formatted(text(goal)));
    }

    /// The cell of a place on the map, or the nearest one that is open; −1 when none is so near.
    ///
    /// @param within [m]
    static int nearest(OccupancyGrid grid, Point2d place, double within, IntPredicate isOpen) {
        int column = grid.column(place.x());
        int row = grid.row(place.y());
        int width = grid.width();
        if (isOpen.test(row * width + column)) {
            return row * width + column;
        }
        int reach = (int) Math.ceil(within / grid.resolution());
        int nearest = -1;
        double best = Double.POSITIVE_INFINITY;
        for (int r = Math.max(0, row - reach); r <= Math.min(grid.height() - 1, row + reach); r++) {
            for (int c = Math.max(0, column - reach); c <= Math.min(width - 1, column + reach); c++) {
                double distance = Math.hypot(grid.x(c) - place.x(), grid.y(r) - place.y());
                if (distance <= within && distance < best && isOpen.test(r * width + c)) {
                    best = distance;
                    nearest = r * width + c;
                }
            }
        }
        return nearest;
    }

    private static String whyNot(OccupancyGrid grid, Point2d goal, IntPredicate isOpen) {
        String why = switch (grid.at(grid.column(goal.x()), grid.row(goal.y()))) {
            case OccupancyGrid.OCCUPIED -> "in a wall";
            case OccupancyGrid.UNKNOWN -> "in unknown space of the map";
            default -> "too near to an obstacle for this robot";
        };
        int instead = nearest(grid, goal, LOOK_AROUND, isOpen);
        return instead < 0
                ? why + "."
                : "%s; the nearest place for it is %s.".formatted(why, text(grid.middle(instead)));
    }

    private static None none(String why, Point2d place) {
        return new None(new Plan.None(why.formatted(text(place))));
    }

    private static String text(Point2d place) {
        return String.format(Locale.ROOT, "(%.2f, %.2f)", place.x(), place.y());
    }
}
