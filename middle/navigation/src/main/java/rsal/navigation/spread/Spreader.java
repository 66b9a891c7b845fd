package rsal.navigation.spread;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import rsal.data.Point2d;

/// Spreads a number of places evenly over a [ReachableSpace]: makes the mean square of the way from anywhere on
/// it to the nearest of them small ([Evenness#rms]).
///
/// The square is J. Cortés's and S. Lloyd's choice, too: in an open hall it packs places like honeycombs, each
/// in the middle of its region; and, unlike the plain mean, it gives a room of its own a place before a second
/// one in a hall that has one. The greatest distance alone would put places against walls and leave all but one
/// free to be anywhere.
///
/// Places are where two robots fit side by side, that is with twice the clearance, so that none stands in a
/// door where nobody else gets by, unless less than half of the ground is so wide. In the office that makes the
/// ways to 10 places 1.3 % longer.
///
/// Works from coarse to fine: on at most 2000 patches of the ground the best of some choices that no swap
/// betters ([Medoids]), then downhill on tens of thousands ([Descent]). More places than that coarse level can
/// tell apart begin each as far as can be from those before (T. Gonzalez, Clustering to minimize the maximum
/// intercluster distance, Theoretical Computer Science 38, 1985) and go downhill from there.
///
/// The same random numbers give the same places. Safe for several threads at once: what is computed of the ground never
/// changes, and each call has arrays of its own.
public final class Spreader {
    private static final int MOST_SWAPPED = 128;
    private static final int PATCHES_PER_PLACE = 32;
    private static final int PATCHES = 20_000;
    private static final int STARTS = 8;
    private static final int DESCENTS = 4; // of the best of them
    private static final int ROOMY_PER_PLACE = 4; // patches

    private final ReachableSpace ground;
    private final int number;
    private final Patches fine;
    private final Optional<Coarse> coarse;
    private final boolean anywhere;

    private record Coarse(Patches patches, PatchDistances distances) {}

    /// What was chosen on the coarse level, and the sum of its squares.
    private record Choice(int[] patches, double sum) {}

    /// Looks at the ground; takes most of the time if it is large.
    ///
    /// @throws IllegalArgumentException when no place is asked for, or more than there is room for
    public Spreader(ReachableSpace ground, int number) {
        if (number < 1) {
            throw new IllegalArgumentException(
                    "At least 1 place must be asked for, not '%d'. Maybe there is no robot to spread."
                            .formatted(number));
        }
        if (number > ground.cells().length) {
            throw noRoom(ground, number);
        }
        this.ground = ground;
        this.number = number;
        int most = Math.max(PATCHES, Math.multiplyExact(PATCHES_PER_PLACE, Math.min(number, 1 << 24)));
        int side = Patches.side(ground.cells().length, most);
        var patches = new Patches(ground, side);
        while (patches.count() > 4 * most) { // passages as narrow as cells
            side *= 2;
            patches = new Patches(ground, side);
        }
        this.fine = patches;
        this.coarse = number <= MOST_SWAPPED ? coarse(side) : Optional.empty();
        int roomy = count(fine.roomy());
        this.anywhere = roomy < fine.count() / 2
                || roomy < (long) ROOMY_PER_PLACE * number
                || coarse.map(level -> count(level.patches.roomy()) < number).orElse(false);
    }

    private static int count(boolean[] values) {
        int count = 0;
        for (boolean value : values) {
            count += value ? 1 : 0;
        }
        return count;
    }

    private boolean[] mayStand(Patches patches) {
        return anywhere ? all(patches) : patches.roomy();
    }

    private static boolean[] all(Patches patches) {
        var all = new boolean[patches.count()];
        Arrays.fill(all, true);
        return all;
    }

    private Optional<Coarse> coarse(int fineSide) {
        int times = Patches.side(fine.count(), PatchDistances.MOST);
        Patches first = times == 1 ? fine : new Patches(ground, fineSide * times);
        // blocks of whole blocks: no two places get the same
        Patches patches = Patches.atMost(ground, first, fineSide, PatchDistances.MOST);
        return patches.count() >= number
                ? Optional.of(new Coarse(patches, PatchDistances.between(patches)))
                : Optional.empty();
    }

    /// Spreads the places.
    ///
    /// @param progress told from time to time how much is done, up to 1
    /// @throws IllegalArgumentException when there is no room for robots as wide as twice the ground's clearance
    public Spread spread(RandomGenerator random, DoubleConsumer progress) {
        var descent = new Descent(fine);
        int[] best = new int[0];
        double least = Double.POSITIVE_INFINITY;
        List<int[]> starts = coarse.map(level -> chosen(level, random, progress))
                .orElseGet(() -> List.of(farFromEachOther(mayStand(fine), random)));
        for (int i = 0; i < starts.size(); i++) {
            int[] at = starts.get(i);
            double sum = descent.descend(at, mayStand(fine));
            if (sum < least) {
                least = sum;
                best = at;
            }
            progress.accept((STARTS + (double) STARTS * (i + 1) / starts.size()) / (2 * STARTS));
        }
        Spread spread = result(best);
        if (!haveRoom(spread.places())) {
            throw noRoom(ground, number);
        }
        return spread;
    }

    private List<int[]> chosen(Coarse level, RandomGenerator random, DoubleConsumer progress) {
        boolean[] may = mayStand(level.patches);
        var medoids = new Medoids(level.distances);
        var choices = new Choice[STARTS];
        for (int i = 0; i < STARTS; i++) {
            int[] chosen = medoids.seed(number, may, random);
            choices[i] = new Choice(chosen, medoids.swap(chosen, may));
            progress.accept((i + 1.0) / (2 * STARTS));
        }
        return Arrays.stream(choices)
                .sorted((a, b) -> Double.compare(a.sum, b.sum))
                .limit(DESCENTS)
                .map(choice -> finer(level.patches, choice.patches))
                .toList();
    }

    /// One run of Lloyd's from random places, without seeds, swaps and regard for doors: what to compare with.
    /// Exact medoids on the coarse level, then downhill on the fine one.
    public Spread lloyd(RandomGenerator random) {
        int[] at = coarse.map(level -> {
                    var medoids = new Medoids(level.distances);
                    int[] chosen = medoids.anywhere(number, random);
                    medoids.lloyd(chosen);
                    return finer(level.patches, chosen);
                })
                .orElseGet(() -> farFromEachOther(all(fine), random));
        new Descent(fine).descend(at, all(fine));
        return result(at);
    }

    private int[] finer(Patches patches, int[] chosen) {
        return Arrays.stream(chosen).map(patch -> fine.of(patches.place(patch))).toArray();
    }

    private int[] farFromEachOther(boolean[] may, RandomGenerator random) {
        var at = new int[number];
        var flood = new Flood(fine);
        int farthest = random.nextInt(fine.count());
        while (!may[farthest]) {
            farthest = (farthest + 1) % fine.count();
        }
        for (int place = 0; place < number; place++) {
            at[place] = farthest;
            flood.source(farthest, place);
            flood.flood();
            for (int patch = 0; patch < fine.count(); patch++) {
                farthest = may[patch] && flood.distance(patch) > flood.distance(farthest) ? patch : farthest;
            }
        }
        return at;
    }

    private Spread result(int[] at) {
        List<Point2d> places = IntStream.of(at)
                .mapToObj(patch -> ground.map().middle(fine.place(patch)))
                .toList();
        return new Spread(places, ground.measure(places));
    }

    private boolean haveRoom(List<Point2d> places) {
        for (int i = 0; i < places.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (places.get(i).distanceTo(places.get(j)) < 2 * ground.clearance()) {
                    return false;
                }
            }
        }
        return true;
    }

    private static IllegalArgumentException noRoom(ReachableSpace ground, int number) {
        return new IllegalArgumentException(String.format(
                Locale.ROOT,
                "There is no room for %d places: on %.2f m² some would be nearer to each other than twice the clearance"
                        + " (%.2f m). Maybe fewer will do, or a smaller clearance.",
                number,
                ground.area(),
                ground.clearance()));
    }
}
