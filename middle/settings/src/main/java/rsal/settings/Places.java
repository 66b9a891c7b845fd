package rsal.settings;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;

/// Places as people type them: `-20 4; 3.5 -1`, in the map [m].
final class Places {
    private Places() {}

    /// @return empty when it can't be read as that; a blank text names none
    static Optional<List<Point2d>> read(String text) {
        var places = new ArrayList<Point2d>();
        if (text.isBlank()) {
            return Optional.of(places);
        }
        for (String place : text.split(";", -1)) {
            String[] numbers = place.strip().split("[\\s,]+", -1);
            if (numbers.length != 2) {
                return Optional.empty();
            }
            try {
                var point = new Point2d(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]));
                if (!Double.isFinite(point.x()) || !Double.isFinite(point.y())) {
                    return Optional.empty();
                }
                places.add(point);
            } catch (NumberFormatException _) {
                return Optional.empty();
            }
        }
        return Optional.of(places);
    }
}
