package rsal.navigation.spread;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.spread.UnsuitablePlace.Reason;
import rsal.navigation.wavefront.NavigationFunction;
import rsal.navigation.wavefront.Wavefront;

/// Where the middle of a robot can be on a map with some clearance to all that is not free, and get from each place
/// to each: one connected part of it. Of the map's outermost cells nothing counts as known.
///
/// Ways lead along sides and diagonals of cells, as planners count them ([Wavefront]), so that they are at most 8 %
/// longer than a taut string. Immutable.
public final class ReachableSpace {
    private static final double ESCAPE = 1; // m; so far from where it can be a robot may start, as for planners

    private static final double INSTEAD = 5; // m; so far from a place another is named that may be meant

    private final ConnectedComponents parts;
    private final int part;
    private final int[] cells;

    private ReachableSpace(ConnectedComponents parts, int part) {
        this.parts = parts;
        this.part = part;
        this.cells = parts.cells(part);
    }

    /// The largest connected part of a map.
    ///
    /// @param clearance least distance to the next cell that is not free [m]: a robot's radius
    /// @throws IllegalArgumentException when the clearance is no distance, or there is no place with so much of it
    public static ReachableSpace largest(OccupancyGrid map, double clearance) {
        var parts = new ConnectedComponents(map, clearance);
        return new ReachableSpace(parts, orNowhere(parts, parts.largest()));
    }

    /// The part that can be reached from a place, which may be up to 1 m off it.
    ///
    /// @param clearance as for the [#largest]
    /// @throws IllegalArgumentException the same, or when a robot can be nowhere near the start
    public static ReachableSpace around(OccupancyGrid map, double clearance, Point2d start) {
        var parts = new ConnectedComponents(map, clearance);
        orNowhere(parts, parts.largest());
        int part = start(parts, start);
        if (part == ConnectedComponents.NONE) {
            throw new IllegalArgumentException(
                    ("From the start %s nothing can be reached: no place within %s m of it has '%s' m of clearance."
                                    + " Maybe it is meant for another map, or the clearance is too large.")
                            .formatted(text(start), number(ESCAPE), number(clearance)));
        }
        return new ReachableSpace(parts, part);
    }

    /// The part in which most of some places are, of several the larger one; the largest when none is in any.
    ///
    /// @param clearance as for the [#largest]
    /// @throws IllegalArgumentException the same
    public static ReachableSpace holding(OccupancyGrid map, double clearance, List<Point2d> places) {
        var parts = new ConnectedComponents(map, clearance);
        orNowhere(parts, parts.largest());
        return new ReachableSpace(parts, mostOf(parts, places));
    }

    private static int mostOf(ConnectedComponents parts, List<Point2d> places) {
        int best = parts.largest();
        var held = new int[parts.count()];
        for (Point2d place : places) {
            int part = parts.of(place);
            if (part != ConnectedComponents.NONE) {
                held[part]++;
            }
        }
        for (int part = 0; part < held.length; part++) {
            boolean larger = held[part] == held[best] && parts.size(part) > parts.size(best);
            best = held[part] > held[best] || larger ? part : best;
        }
        return best;
    }

    /// Looks at places that somebody gave robots to go to: which of them can't be reached from any of their starts,
    /// each of which may be up to 1 m off where a robot can be.
    ///
    /// @param clearance as for the [#largest]
    /// @param starts when there are none, robots are where most of the places are
    /// @param within how near to it is near enough, for each place [m]
    /// @return in their order; empty when all will do
    /// @throws IllegalArgumentException as for the [#largest]
    public static List<UnsuitablePlace> check(
            OccupancyGrid map, double clearance, List<Point2d> starts, List<Point2d> places, List<Double> within) {
        var parts = new ConnectedComponents(map, clearance);
        orNowhere(parts, parts.largest());
        var reached = new TreeSet<Integer>();
        for (Point2d start : starts) {
            reached.add(start(parts, start));
        }
        reached.remove(ConnectedComponents.NONE);
        if (reached.isEmpty()) {
            reached.add(mostOf(parts, places));
        }
        var wrong = new ArrayList<UnsuitablePlace>();
        var ground = new ReachableSpace(parts, reached.getFirst());
        for (int i = 0; i < places.size(); i++) {
            Point2d place = places.get(i);
            double near = within.get(i);
            if (reached.stream()
                    .noneMatch(part -> parts.of(place) == part
                            || parts.nearest(place, near, part).isPresent())) {
                boolean isElsewhere = parts.nearest(place, near) != ConnectedComponents.NONE;
                wrong.add(ground.misplaced(i, place, isElsewhere ? Reason.CUT_OFF : ground.reason(place)));
            }
        }
        return List.copyOf(wrong);
    }

    /// The part that a robot at a place is in, [ConnectedComponents#NONE] when it is nowhere near any.
    private static int start(ConnectedComponents parts, Point2d start) {
        int own = parts.of(start);
        return own == ConnectedComponents.NONE ? parts.nearest(start, ESCAPE) : own;
    }

    private static int orNowhere(ConnectedComponents parts, int part) {
        if (part == ConnectedComponents.NONE) {
            OccupancyGrid map = parts.map();
            double most = 0;
            for (int cell = 0; cell < map.cells().length; cell++) {
                most = Math.max(most, parts.toNotFree().at(cell) - map.resolution() / 2);
            }
            throw new IllegalArgumentException(
                    ("No place on the map has a clearance of '%s' m; the most there is are %s m. Maybe the clearance is"
                                    + " too large, or too little of the map is free.")
                            .formatted(number(parts.clearance()), number(most)));
        }
        return part;
    }

    /// Least distance to the next cell that is not free [m].
    public double clearance() {
        return parts.clearance();
    }

    /// How large it is [m²].
    public double area() {
        double side = parts.map().resolution();
        return cells.length * side * side;
    }

    public boolean contains(Point2d place) {
        return parts.of(place) == part;
    }

    /// Whether a robot at a place, which may be up to 1 m off it, starts on it: [#around] the place is the
    /// same.
    public boolean isReachedFrom(Point2d start) {
        return start(parts, start) == part;
    }

    /// Measures how evenly some places are spread over it.
    ///
    /// @throws IllegalArgumentException when one is not on it, or there is none
    public Evenness measure(List<Point2d> places) {
        check(places).stream().findFirst().ifPresent(wrong -> {
            throw new IllegalArgumentException(wrong.why());
        });
        NavigationFunction nearest = new Wavefront(parts.open())
                .everywhere(places, 0)
                .orElseThrow(() -> new IllegalArgumentException("At least one place must be asked for, not 0."));
        OccupancyGrid map = parts.map();
        double sum = 0;
        double squares = 0;
        double greatest = 0;
        for (int cell : cells) {
            double distance = nearest.cost(map.middle(cell));
            sum += distance;
            squares += distance * distance;
            greatest = Math.max(greatest, distance);
        }
        return new Evenness(sum / cells.length, Math.sqrt(squares / cells.length), greatest);
    }

    /// Length of the shortest path between two of some places on it [m]; infinite for fewer than two.
    double least(List<Point2d> places) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 1; i < places.size(); i++) {
            NavigationFunction before = new Wavefront(parts.open())
                    .everywhere(places.subList(0, i), 0)
                    .orElseThrow();
            least = Math.min(least, before.cost(places.get(i)));
        }
        return least;
    }

    /// Looks at places that somebody gave: which of them are not on it, and why. From each of the others a robot can
    /// get to each.
    ///
    /// @return in their order; empty when all will do
    public List<UnsuitablePlace> check(List<Point2d> places) {
        var wrong = new ArrayList<UnsuitablePlace>();
        for (int i = 0; i < places.size(); i++) {
            if (!contains(places.get(i))) {
                wrong.add(misplaced(i, places.get(i), reason(places.get(i))));
            }
        }
        return List.copyOf(wrong);
    }

    private UnsuitablePlace misplaced(int index, Point2d place, Reason reason) {
        return new UnsuitablePlace(index, place, reason, why(place, reason));
    }

    private Reason reason(Point2d place) {
        OccupancyGrid map = parts.map();
        if (!map.contains(map.column(place.x()), map.row(place.y()))) {
            return Reason.OUTSIDE;
        }
        return parts.of(place) != ConnectedComponents.NONE
                ? Reason.CUT_OFF
                : switch (map.at(map.column(place.x()), map.row(place.y()))) {
                    case OccupancyGrid.OCCUPIED -> Reason.OCCUPIED;
                    case OccupancyGrid.UNKNOWN -> Reason.UNKNOWN;
                    default -> Reason.TOO_NEAR;
                };
    }

    private String why(Point2d place, Reason reason) {
        double clear = Math.max(
                0, parts.toNotFree().at(place.x(), place.y()) - parts.map().resolution() / 2);
        String what = switch (reason) {
            case OUTSIDE -> "is outside the map";
            case OCCUPIED -> "is in a wall, or in something else that stands there";
            case UNKNOWN -> "is in unknown space of the map";
            case TOO_NEAR ->
                "is '%s' m from an obstacle or unknown space, nearer than '%s' m"
                        .formatted(number(clear), number(clearance()));
            case CUT_OFF -> "cannot be reached with '%s' m of clearance".formatted(number(clearance()));
        };
        String instead = nearest(place)
                .map(near -> "Maybe the nearest place that will do is meant, %s.".formatted(text(near)))
                .orElse(
                        reason == Reason.CUT_OFF
                                ? "Maybe a passage on the way there is too narrow."
                                : "Maybe it is meant for another map.");
        return "Place %s %s. %s".formatted(text(place), what, instead);
    }

    /// Not farther than it may be meant.
    private Optional<Point2d> nearest(Point2d place) {
        OccupancyGrid map = parts.map();
        return parts.nearest(place, INSTEAD, part).stream()
                .mapToObj(map::middle)
                .findFirst();
    }

    OccupancyGrid map() {
        return parts.map();
    }

    /// Numbers of its cells, row by row. Not to be written to.
    int[] cells() {
        return cells;
    }

    boolean isIn(int cell) {
        return parts.isIn(cell, part);
    }

    /// Whether a passage through the cell is wide enough for two robots: it has twice the clearance.
    boolean isRoomy(int cell) {
        return parts.toNotFree().at(cell) - parts.map().resolution() / 2 >= 2 * clearance();
    }

    private static String text(Point2d place) {
        return "(%s, %s)".formatted(number(place.x()), number(place.y()));
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }
}
