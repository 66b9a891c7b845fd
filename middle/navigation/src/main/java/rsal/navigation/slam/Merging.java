package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;
import rsal.navigation.scanmatch.CorrelativeMatcher;
import rsal.navigation.scanmatch.CorrelativeMatcher.Spot;
import rsal.navigation.scanmatch.CorrelativeMatcher.Window;
import rsal.navigation.scanmatch.LineMatcher;
import rsal.navigation.scanmatch.Match;

/// Finds how the maps of two robots lie to each other when nobody knows: parts of one are searched for, by
/// correlation, everywhere and in any heading in the other, and the place counts on which most of them agree.
/// After S. Carpin, Fast and Accurate Map Merging for Multi-Robot Systems, Autonomous Robots 25 (2008), which
/// searches spectra instead, and Olson's search of scans (see [CorrelativeMatcher]).
///
/// Each part is searched for twice: where it fits best, and best elsewhere. Of the places on which parts agree,
/// those are rivals that have about as many for them; of these the one counts at which the fewest beams of either
/// map go through what the other hit, if it is clearly the one. Where many do, parts agree on what only looks alike.
final class Merging {
    private static final int PARTS = 12; // of a map, searched for
    private static final int FRAMES = 6; // of a part, to either side
    private static final double THINNED = 0.3; // m
    private static final double LEAST_SCORE = 0.5;
    private static final double LEAST_PAIRS = 0.6;
    private static final double AGREE_METERS = 1;
    private static final double AGREE_RADIANS = 0.1;
    private static final int AGREEING = 2;
    private static final double ELSEWHERE_METERS = 1.5;
    private static final double ELSEWHERE_RADIANS = 0.3;
    private static final double RIVAL = 0.8; // of the support of the best
    private static final double MOST_THROUGH = 0.35; // of the beams, at a place that may be right
    private static final double MORE = 1.5; // times the beams that go through walls, by which a rival is out
    private static final double MORE_AT_LEAST = 0.015; // of the beams
    private static final CorrelativeMatcher.Settings SEARCH = new CorrelativeMatcher.Settings(0.15, 0.15, 8);

    /// @param part of `b` that fits there
    private record Found(int part, Pose2d aFromB, double score) {}

    /// A place on which parts agree.
    ///
    /// @param support sum of their scores
    private record Place(Pose2d aFromB, double support) {}

    /// Where the map of one lies in that of another.
    sealed interface Alignment {}

    record One(Pose2d aFromB) implements Alignment {}

    /// In two places about as well.
    record Ambiguous(Pose2d aFromB, Pose2d rival) implements Alignment {}

    record Nowhere() implements Alignment {}

    private Merging() {}

    /// Where the map's frame of `b` is in that of `a`, if it is there at all.
    static Alignment align(List<GraphNode> framesA, List<Pose2d> a, List<GraphNode> framesB, List<Pose2d> b) {
        List<Place> places = places(found(framesA, a, framesB, b), middle(b));
        if (places.isEmpty()) {
            return new Nowhere();
        }
        double most = places.getFirst().support();
        List<Place> candidates =
                places.stream().filter(p -> p.support() >= RIVAL * most).toList();
        var seenThrough = new ArrayList<Double>();
        var hitsOfA = new Transparency(LocalMap.of(framesA, a, 0, framesA.size() - 1, 0));
        var hitsOfB = new Transparency(LocalMap.of(framesB, b, 0, framesB.size() - 1, 0));
        int best = 0;
        for (int i = 0; i < candidates.size(); i++) {
            Pose2d aFromB = candidates.get(i).aFromB();
            seenThrough.add((hitsOfA.through(framesB, b, a.getFirst().inverse().compose(aFromB))
                            + hitsOfB.through(framesA, a, b.getFirst().inverse().compose(aFromB.inverse())))
                    / 2);
            best = seenThrough.get(i) < seenThrough.get(best) ? i : best;
        }
        if (seenThrough.get(best) > MOST_THROUGH) {
            return new Nowhere();
        }
        double bound = MORE * seenThrough.get(best) + MORE_AT_LEAST;
        for (int i = 0; i < candidates.size(); i++) {
            if (i != best && seenThrough.get(i) <= bound) {
                return new Ambiguous(
                        candidates.get(best).aFromB(), candidates.get(i).aFromB());
            }
        }
        return new One(candidates.get(best).aFromB());
    }

    private static List<Found> found(List<GraphNode> framesA, List<Pose2d> a, List<GraphNode> framesB, List<Pose2d> b) {
        Pose2d aFromFirst = a.getFirst();
        Cloud whole = LocalMap.of(framesA, a, 0, framesA.size() - 1, 0).thinned(0.1);
        var found = new ArrayList<Found>();
        if (whole.count() == 0) {
            return found;
        }
        double size = a.stream().mapToDouble(aFromFirst::distanceTo).max().orElse(0);
        Pose2d guess = aFromFirst.inverse().compose(middle(a));
        var window = new Window(size + 5, Math.PI);
        var matcher = new CorrelativeMatcher(whole, SEARCH);
        var lines = new LineMatcher(whole);
        int parts = Math.min(PARTS, framesB.size());
        for (int part = 0; part < parts; part++) {
            int number = part;
            int center = (int) ((part + 0.5) * framesB.size() / parts);
            Cloud here = LocalMap.of(framesB, b, center - FRAMES, center + FRAMES, center);
            Cloud thin = here.thinned(THINNED);
            Optional<Match> first = matcher.match(thin, guess, window, LEAST_SCORE);
            Optional<Match> second = first.flatMap(match -> matcher.matchElsewhere(
                    thin,
                    guess,
                    window,
                    Math.max(LEAST_SCORE, RIVAL * match.score()),
                    new Spot(match.aFromB(), ELSEWHERE_METERS, ELSEWHERE_RADIANS)));
            Stream.of(first, second)
                    .flatMap(Optional::stream)
                    .flatMap(coarse -> lines.match(here, coarse.aFromB()).stream())
                    .filter(match -> match.score() >= LEAST_PAIRS)
                    .forEach(match -> found.add(new Found(
                            number,
                            aFromFirst
                                    .compose(match.aFromB())
                                    .compose(b.get(center).inverse()),
                            match.score())));
        }
        return found;
    }

    private static Pose2d middle(List<Pose2d> poses) {
        double x = poses.stream().mapToDouble(Pose2d::x).average().orElse(0);
        double y = poses.stream().mapToDouble(Pose2d::y).average().orElse(0);
        return new Pose2d(x, y, 0);
    }

    /// Those on which several parts agree, told apart at a place in the middle of `b`, most support first.
    private static List<Place> places(List<Found> found, Pose2d middle) {
        var all = new ArrayList<Place>();
        for (Found one : found) {
            List<Found> agreeing = found.stream()
                    .filter(other -> isSame(one.aFromB(), other.aFromB(), middle))
                    .toList();
            double sum = agreeing.stream().mapToDouble(Found::score).sum() + one.score() * 1e-3;
            if (agreeing.stream().map(Found::part).distinct().count() >= AGREEING) {
                all.add(new Place(one.aFromB(), sum));
            }
        }
        all.sort(Comparator.comparingDouble(Place::support).reversed());
        var places = new ArrayList<Place>();
        for (Place place : all) {
            if (places.stream().noneMatch(p -> isSame(p.aFromB(), place.aFromB(), middle))) {
                places.add(place);
            }
        }
        return places;
    }

    private static boolean isSame(Pose2d aFromB, Pose2d other, Pose2d middle) {
        return other.compose(middle).isNear(aFromB.compose(middle), AGREE_METERS, AGREE_RADIANS);
    }
}
