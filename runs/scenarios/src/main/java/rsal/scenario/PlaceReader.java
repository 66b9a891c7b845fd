package rsal.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.settings.Section;

/// Reads the group `places`.
final class PlaceReader {
    private PlaceReader() {}

    static List<Place> read(Section places) {
        var all = new ArrayList<Place>();
        for (String name : places.names()) {
            Section place = places.section(name);
            if (!PlanReader.isName(name)) {
                place.problem(place.location(), "'%s' can't be the name of a place.".formatted(name), "");
            }
            area(name, place).ifPresent(area -> all.add(new Place(name, area)));
            place.done();
        }
        places.done();
        return all;
    }

    private static Optional<Place.Area> area(String name, Section place) {
        double radius = (Double) place.value(Format.PLACE_RADIUS).orElse(1.0);
        if (place.has("at") == place.has("within")) {
            place.problem(
                    place.location(),
                    place.has("at")
                            ? "Place '%s' has both 'at' and 'within'.".formatted(name)
                            : "Place '%s' needs 'at' or 'within'.".formatted(name),
                    "Write {at: [x, y], radius: 1}, or {within: [least x, least y, greatest x, greatest y]}.");
            return Optional.empty();
        }
        if (place.has("at")) {
            return place.numbers("at", 2).map(xy -> new Place.Disc(new Point2d(xy[0], xy[1]), radius));
        }
        return rectangle(place).map(area -> area);
    }

    /// What the setting `within` says; empty when it isn't given, or an error.
    static Optional<Place.Rectangle> rectangle(Section section) {
        double[] edges = section.numbers("within", 4).orElse(new double[0]);
        if (edges.length == 0) {
            return Optional.empty();
        }
        if (!(edges[0] < edges[2] && edges[1] < edges[3])) {
            section.problem("within", "'within' must be [least x, least y, greatest x, greatest y].", "");
            return Optional.empty();
        }
        return Optional.of(new Place.Rectangle(new Point2d(edges[0], edges[1]), new Point2d(edges[2], edges[3])));
    }
}
