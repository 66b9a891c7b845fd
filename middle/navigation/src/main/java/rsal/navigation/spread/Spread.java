package rsal.navigation.spread;

import java.util.List;
import rsal.data.Point2d;

/// Places spread over a [ReachableSpace].
///
/// @param places from each of which a robot can get to each
public record Spread(List<Point2d> places, Evenness evenness) {
    public Spread {
        places = List.copyOf(places);
    }
}
