package rsal.navigation.spread;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import rsal.navigation.rooms.MapRegion;
import rsal.navigation.rooms.RegionKind;
import rsal.navigation.rooms.RoomGate;
import rsal.navigation.rooms.RoomMap;

/// Chooses one place in each of as many rooms as there are robots, so that the two nearest are far apart,
/// and then nothing is far from all. For up to 40 rooms the first aim is reached exactly, the second among
/// at most 2000 choices that are equally far apart ([RoomSubset]). For more rooms, or where that takes too
/// many steps, swaps come near to the first aim alone ([ApartChoice]). Within a room that is the place with
/// room for two robots from which the path to the nearest gate is longest: behind the door, out of the way.
///
/// With more robots than rooms, each room has one. The others go one by one to where most robots are
/// missing from the share of the floor, so that their number does not depend on the order of the rooms. A
/// corridor counts for at most one robot in 15 m of it.
final class RoomChoice {
    private static final int EXACT = 40; // rooms
    private static final double CORRIDOR = 15; // m for each robot in a corridor
    private static final double NEAR_GATE = 2; // m, from a gate to the next candidate

    private final Candidates candidates;
    private final int[] may;
    private final RoomMap rooms;
    private final List<Part> parts = new ArrayList<>(); // rooms and corridors that can be reached

    /// @param standing what robots may stand on
    /// @param most robots that it may have
    private record Part(MapRegion region, int[] standing, int most) {
        boolean isRoom() {
            return region.kind() == RegionKind.ROOM;
        }
    }

    RoomChoice(Candidates candidates, int[] may, RoomMap rooms) {
        this.candidates = candidates;
        this.may = may;
        this.rooms = rooms;
        for (MapRegion region : rooms.regions()) {
            int[] standing = in(region, may);
            if (standing.length == 0) { // narrow, but a robot fits in
                standing = in(region, IntStream.range(0, candidates.count()).toArray());
            }
            if (standing.length > 0 && region.kind() != RegionKind.CLOSET) {
                boolean isRoom = region.kind() == RegionKind.ROOM;
                int most = isRoom ? Integer.MAX_VALUE : (int) (longest(standing) / CORRIDOR);
                parts.add(new Part(region, standing, most));
            }
        }
    }

    private int[] in(MapRegion region, int[] some) {
        return Arrays.stream(some)
                .filter(candidate -> rooms.regionOf(candidates.cell(candidate)) == region.number())
                .toArray();
    }

    /// Path within a corridor, nearly [m].
    private double longest(int[] standing) {
        int end = standing[0];
        double longest = 0;
        for (int tries = 0; tries < 2; tries++) {
            int from = end;
            for (int candidate : standing) {
                if (candidates.length(from, candidate) > longest) {
                    longest = candidates.length(from, candidate);
                    end = candidate;
                }
            }
        }
        return longest;
    }

    /// The place of each room that can be reached, in the order of the rooms.
    int[] places() {
        return parts.stream().filter(Part::isRoom).mapToInt(this::behindTheDoor).toArray();
    }

    private int behindTheDoor(Part part) {
        int[] gates = rooms.gatesOf(part.region.number()).stream()
                .map(RoomGate::middle)
                .filter(gate -> candidates.place(candidates.nearest(gate)).distanceTo(gate) < NEAR_GATE)
                .mapToInt(candidates::nearest)
                .toArray();
        if (gates.length == 0) {
            return Arrays.stream(part.standing)
                    .boxed()
                    .min(Comparator.comparingDouble(
                            candidate -> candidates.place(candidate).distanceTo(part.region.middle())))
                    .orElseThrow();
        }
        int best = part.standing[0];
        double farthest = -1;
        for (int candidate : part.standing) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int gate : gates) {
                nearest = Math.min(nearest, candidates.length(gate, candidate));
            }
            if (nearest > farthest) {
                farthest = nearest;
                best = candidate;
            }
        }
        return best;
    }

    /// @return empty when there is no room
    int[] choose(int number) {
        int[] places = separate(places());
        if (places.length == 0) {
            return new ApartChoice(candidates, may).choose(number);
        }
        if (number > places.length) {
            return more(places, number);
        }
        int[] best = places.length <= EXACT ? RoomSubset.best(candidates, places, number) : new int[0];
        return best.length == number ? best : new ApartChoice(candidates, places).choose(number);
    }

    /// Without those that are too near to others before.
    private int[] separate(int[] places) {
        int[] kept = new int[0];
        for (int place : places) {
            if (!candidates.isTooNear(place, kept, -1)) {
                kept = Arrays.copyOf(kept, kept.length + 1);
                kept[kept.length - 1] = place;
            }
        }
        return kept;
    }

    /// Fills rooms by their share of the floor, each as far as can be from all that are there.
    private int[] more(int[] places, int number) {
        int[] chosen = places;
        int[] seats = seats(number);
        for (int i = 0; i < parts.size(); i++) {
            int there = parts.get(i).isRoom() ? 1 : 0;
            int wanted = Math.min(number, chosen.length + Math.max(0, seats[i] - there));
            chosen = FarthestFirst.extended(candidates, parts.get(i).standing, chosen, wanted);
        }
        return chosen.length == number ? chosen : FarthestFirst.extended(candidates, may, chosen, number);
    }

    /// How many robots each part has: one in each room, then one after the other where the share of the
    /// area exceeds what is there most. This is the method of largest remainders, except that a room never
    /// has none.
    private int[] seats(int number) {
        var seats = new int[parts.size()];
        double area = parts.stream().mapToDouble(part -> part.region.area()).sum();
        int left = number;
        for (int i = 0; i < seats.length; i++) {
            seats[i] = parts.get(i).isRoom() ? 1 : 0;
            left -= seats[i];
        }
        for (; left > 0; left--) {
            int best = -1;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < seats.length; i++) {
                double owed = number * parts.get(i).region.area() / area - seats[i];
                if (seats[i] < parts.get(i).most && owed > most) {
                    most = owed;
                    best = i;
                }
            }
            if (best < 0) {
                return seats;
            }
            seats[best]++;
        }
        return seats;
    }
}
