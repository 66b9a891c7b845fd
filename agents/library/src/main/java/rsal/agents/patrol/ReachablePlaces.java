package rsal.agents.patrol;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import rsal.agents.patrol.strategy.PatrolGraph;
import rsal.agents.patrol.strategy.PatrolView;
import rsal.data.Point2d;

/// The places of an order that can be reached from each other; the others are left out of a patrol. Robots
/// speak of places by their numbers in the order, strategies by those among the reachable ones.
final class ReachablePlaces {
    private final List<Point2d> mapFromPlaces; // of the order
    private final PatrolGraph graph;
    private final int[] ordered; // number in the order, by place
    private final int[] places; // by number in the order

    /// @param mapFromPlaces of the order
    /// @param all paths between them, some of which may not exist
    ReachablePlaces(List<Point2d> mapFromPlaces, PatrolGraph all) {
        this.mapFromPlaces = mapFromPlaces;
        this.ordered = all.largestPart();
        this.graph = all.only(ordered);
        this.places = new int[all.size()];
        Arrays.fill(places, PatrolView.NONE);
        for (int place = 0; place < ordered.length; place++) {
            places[ordered[place]] = place;
        }
    }

    PatrolGraph graph() {
        return graph;
    }

    int size() {
        return ordered.length;
    }

    /// How many places the order has.
    int orderSize() {
        return places.length;
    }

    Point2d mapFromPlace(int place) {
        return mapFromPlaces.get(ordered[place]);
    }

    List<Point2d> mapFromReachable() {
        return IntStream.range(0, size()).mapToObj(this::mapFromPlace).toList();
    }

    /// Those that are left out.
    List<Point2d> mapFromOthers() {
        return IntStream.range(0, places.length)
                .filter(number -> places[number] == PatrolView.NONE)
                .mapToObj(mapFromPlaces::get)
                .toList();
    }

    /// The number in the order of a place, or of none.
    int ordered(int place) {
        return place == PatrolView.NONE ? PatrolView.NONE : ordered[place];
    }

    /// The place with a number in the order; [PatrolView#NONE] when it is left out or there is none.
    int place(int number) {
        return number < 0 || number >= places.length ? PatrolView.NONE : places[number];
    }

    /// The place at a position; [PatrolView#NONE] when there is none.
    int placeAt(Point2d mapFromPlace) {
        return place(mapFromPlaces.indexOf(mapFromPlace));
    }
}
