package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;

/// Where intruders were seen last, each followed from sighting to sighting: what is seen is the one that can have got
/// there.
final class Intruders {
    private static final double ERROR = 2.0; // m, of two sightings
    private static final double FASTEST = 1.0; // m/s
    private static final Duration MEMORY = Duration.ofSeconds(30);

    private final List<Track> tracks = new ArrayList<>();

    /// Somebody is seen.
    Track note(Point2d mapFromIntruder, Instant now) {
        tracks.removeIf(track -> track.seen.plus(MEMORY).isBefore(now));
        Track track = of(mapFromIntruder, now).orElseGet(() -> {
            var found = new Track(mapFromIntruder, now);
            tracks.add(found);
            return found;
        });
        track.mapFromIntruder = mapFromIntruder;
        track.seen = now;
        return track;
    }

    /// The one that can be at a place now; of several the nearest.
    Optional<Track> of(Point2d mapFromPlace, Instant now) {
        return tracks.stream()
                .filter(track -> track.mapFromIntruder.distanceTo(mapFromPlace) <= ERROR + FASTEST * track.age(now))
                .min(Comparator.comparingDouble(track -> track.mapFromIntruder.distanceTo(mapFromPlace)));
    }

    /// One intruder.
    static final class Track {
        private Point2d mapFromIntruder;
        private Instant seen;

        Track(Point2d mapFromIntruder, Instant seen) {
            this.mapFromIntruder = mapFromIntruder;
            this.seen = seen;
        }

        /// Where it was seen last.
        Point2d mapFromIntruder() {
            return mapFromIntruder;
        }

        /// How long ago it was seen last [s].
        double age(Instant now) {
            return Duration.between(seen, now).toMillis() / 1000.0;
        }
    }
}
