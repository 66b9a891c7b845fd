package rsal.data;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/// What makes places for a team good. Distances are those of paths.
public enum PlaceObjective {
    /// Each in a room of its own, as far as there are rooms; then the two that are nearest to each other as far
    /// apart as possible; then the place that is farthest from all of them as near as possible.
    ROOMS,
    /// The two that are nearest to each other as far apart as possible (max-min dispersion).
    APART,
    /// The place that is farthest from all of them as near as possible (p-center).
    NEAR,
    /// The mean square of the distance to the nearest of them as small as possible (k-means by paths).
    EVENLY,
    /// As much of the floor as possible in sight of one of them.
    VIEW;

    /// As people write it.
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /// All, as people write them.
    public static List<String> keys() {
        return Arrays.stream(values()).map(PlaceObjective::key).toList();
    }

    public static Optional<PlaceObjective> of(String key) {
        return Arrays.stream(values())
                .filter(objective -> objective.key().equals(key))
                .findFirst();
    }
}
