package rsal.server.frame;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.server.message.Messages;
import rsal.server.message.Messages.ThingInfo;
import rsal.server.message.Messages.Things;

/// The things that viewers are told of. Immutable.
///
/// @param all by number, in the order in which they came
/// @param left how many more there are
public record ObjectRegistry(int run, Map<Integer, ThingInfo> all, int left) {
    /// Told at once.
    public static final int BATCH = 500;

    static final int CORNERS_OF_BATCH = 5000;

    public ObjectRegistry {
        all = Collections.unmodifiableMap(new LinkedHashMap<>(all));
    }

    /// What is news for somebody, as much as is told at once.
    ///
    /// @param known numbers of things that were told, which this changes
    /// @return empty when there is no news
    public Optional<Things> news(Set<Integer> known) {
        List<Integer> gone =
                known.stream().filter(number -> !all.containsKey(number)).toList();
        var came = new ArrayList<ThingInfo>();
        int corners = 0;
        for (ThingInfo thing : all.values()) {
            if (came.size() == BATCH || corners >= CORNERS_OF_BATCH) {
                break;
            }
            if (known.add(thing.number())) {
                came.add(thing);
                corners += corners(thing);
            }
        }
        gone.forEach(known::remove);
        return came.isEmpty() && gone.isEmpty() ? Optional.empty() : Optional.of(new Things(run, came, gone, left));
    }

    public static int corners(ThingInfo thing) {
        return thing.pieces().stream()
                .map(Messages.PieceInfo::corners)
                .mapToInt(Collection::size)
                .sum();
    }
}
