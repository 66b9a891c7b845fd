package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;
import rsal.navigation.scanmatch.CorrelativeMatcher;
import rsal.navigation.scanmatch.CorrelativeMatcher.Window;
import rsal.navigation.scanmatch.LineMatcher;

/// Finds how the maps of two robots lie to each other when nobody knows: parts of one are searched for, by
/// correlation, everywhere and in any heading in the other, and the place counts on which most of them agree.
/// After S. Carpin, Fast and Accurate Map Merging for Multi-Robot Systems, Autonomous Robots 25 (2008), which
/// searches spectra instead, and Olson's search of scans (see [CorrelativeMatcher]).
final class Merging {
    private static final int PARTS = 12; // of a map, searched for
    private static final int FRAMES = 6; // of a part, to either side
    private static final double THINNED = 0.3; // m
    private static final double LEAST_SCORE = 0.5;
    private static final double LEAST_PAIRS = 0.6;
    private static final double AGREE_METERS = 1;
    private static final double AGREE_RADIANS = 0.1;
    private static final int AGREEING = 2;
    private static final CorrelativeMatcher.Settings SEARCH = new CorrelativeMatcher.Settings(0.15, 0.15, 8);

    private record Found(Pose2d aFromB, double score) {}

    private Merging() {}

    /// @return where the map's frame of `b` is in that of `a`; empty when no two parts agree
    static Optional<Pose2d> align(List<Frame> framesA, List<Pose2d> a, List<Frame> framesB, List<Pose2d> b) {
        Pose2d aFromFirst = a.getFirst();
        Cloud whole = Surroundings.of(framesA, a, 0, framesA.size() - 1, 0).thinned(0.1);
        if (whole.count() == 0) {
            return Optional.empty();
        }
        double size = a.stream().mapToDouble(aFromFirst::distanceTo).max().orElse(0);
        Pose2d middle = middle(a);
        var matcher = new CorrelativeMatcher(whole, SEARCH);
        var lines = new LineMatcher(whole);
        var found = new ArrayList<Found>();
        for (int part = 0; part < Math.min(PARTS, framesB.size()); part++) {
            int center = (int) ((part + 0.5) * framesB.size() / Math.min(PARTS, framesB.size()));
            Cloud here = Surroundings.of(framesB, b, center - FRAMES, center + FRAMES, center);
            Pose2d guess = aFromFirst.inverse().compose(middle);
            matcher.match(here.thinned(THINNED), guess, new Window(size + 5, Math.PI), LEAST_SCORE)
                    .flatMap(coarse -> lines.match(here, coarse.aFromB()))
                    .filter(match -> match.score() >= LEAST_PAIRS)
                    .ifPresent(match -> found.add(new Found(
                            aFromFirst
                                    .compose(match.aFromB())
                                    .compose(b.get(center).inverse()),
                            match.score())));
        }
        return agreed(found, middle(b));
    }

    private static Pose2d middle(List<Pose2d> poses) {
        double x = poses.stream().mapToDouble(Pose2d::x).average().orElse(0);
        double y = poses.stream().mapToDouble(Pose2d::y).average().orElse(0);
        return new Pose2d(x, y, 0);
    }

    /// The one that most others agree with, told apart at a place in the middle of `b`.
    private static Optional<Pose2d> agreed(List<Found> found, Pose2d place) {
        Optional<Pose2d> best = Optional.empty();
        double most = 0;
        for (Found one : found) {
            List<Found> agreeing = found.stream()
                    .filter(other -> other.aFromB()
                            .compose(place)
                            .isNear(one.aFromB().compose(place), AGREE_METERS, AGREE_RADIANS))
                    .toList();
            double sum = agreeing.stream().mapToDouble(Found::score).sum() + one.score() * 1e-3;
            if (agreeing.size() >= AGREEING && sum > most) {
                most = sum;
                best = Optional.of(one.aFromB());
            }
        }
        return best;
    }
}
