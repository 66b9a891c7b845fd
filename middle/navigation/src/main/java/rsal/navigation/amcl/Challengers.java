package rsal.navigation.amcl;

import java.util.List;
import java.util.stream.IntStream;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate.Hypothesis;

/// Where else a robot may be that was known to be somewhere and whose odometry is unbroken since. It can have been
/// carried, but that is rare; and of the many places of a building one nearly always fits a single scan better than the
/// right one, where something has been changed. So a place is followed apart from the particles, and taken for the
/// right
/// one only when scans speak against where the robot is followed, when it has been better over some way, when it
/// explains what is seen, and when no other does so as well. Until then the estimate is ambiguous or lost.
///
/// The less the map explains at the pose that is followed, the shorter the way: a robot that was carried to another
/// room sees walls that are not there, one in a room that was drawn badly still sees half of them.
///
/// Not safe for several threads at once.
final class Challengers {
    private static final int MOST = 24;
    private static final double SAME = 0.15; // mean logarithm of a beam's likelihood
    private static final double RULED_OUT = 12; // logarithm of how many times less likely
    private static final double MERGED_METERS = 0.4;
    private static final double MERGED_RADIANS = 0.25;
    private static final double FOLLOWED_METERS = 1.5; // over which shares are averaged
    private static final double SERIOUS_AFTER = 0.5; // m
    private static final double EXPLAINS = 0.75; // share of its beams that end at walls
    private static final double CONTRADICTED = 0.1; // share of its beams that go through walls
    private static final double BETTER = 0.1; // mean logarithm of a beam's likelihood
    private static final double MUCH_BETTER = 0.5; // the same
    private static final double SHORTEST_WAY = 2; // m, where nothing is explained at the pose that is followed
    private static final double LONGEST_WAY = 10; // m, where much of it is
    private static final double LEAST_EXTENT = 0.7; // m, how far it must have come on this way, the same
    private static final double LARGEST_EXTENT = 7; // m
    private static final double LITTLE_EXPLAINED = 0.3;
    private static final double MUCH_EXPLAINED = 0.45;
    /// Share of the beams below which the pose that is followed is doubtful.
    static final double DOUBTFUL = 0.6;

    private static final double NEARBY = 1.5; // m, to where odometry may have led
    private static final double NEARLY_TURNED = 0.7; // rad, the same
    private static final double NEARBY_EXPLAINS = 0.4;
    private static final double NEARBY_BETTER = 1;
    private static final double FAR_BETTER = 2.5; // as right places are than wrong ones
    private static final double A_LITTLE_BETTER = 1.2;

    private final GlobalSearch search;
    private final Refinement refinement;
    private final double independentBeams;
    private final Challenger[] held = new Challenger[MOST];
    private int count;

    /// @param independentBeams number of independent beams for which a scan counts
    Challengers(GlobalSearch search, Refinement refinement, double independentBeams) {
        this.search = search;
        this.refinement = refinement;
        this.independentBeams = independentBeams;
    }

    private static final class Challenger {
        private Pose2d pose;
        private double log; // of how likely it is by what was seen since it was found, at most 0
        private final Pose2d found;
        private double way; // m
        private double extent; // m, from where it was found
        private double advantage; // sum over the way of how much better it fits
        private double hits = Double.NaN;
        private double through;

        Challenger(Pose2d pose) {
            this.pose = pose;
            this.found = pose;
        }

        double better() {
            return way > 0 ? advantage / way : 0;
        }

        boolean isSerious() {
            return way >= SERIOUS_AFTER && better() > BETTER && hits >= EXPLAINS && through <= CONTRADICTED;
        }

        void see(GlobalSearch.Fates fates, double step) {
            if (fates.reported() == 0) {
                return;
            }
            double nowHits = (double) fates.hits() / fates.reported();
            double nowThrough = (double) fates.through() / fates.reported();
            double newest = Double.isNaN(hits) ? 1 : 1 - Math.exp(-step / FOLLOWED_METERS);
            hits = Double.isNaN(hits) ? nowHits : hits + newest * (nowHits - hits);
            through += newest * (nowThrough - through);
        }
    }

    int count() {
        return count;
    }

    void clear() {
        count = 0;
    }

    /// Takes up a place unless it is one of them already, or there are too many.
    void add(Pose2d pose) {
        if (count < MOST && !hasNear(pose, count)) {
            held[count++] = new Challenger(pose);
        }
    }

    private boolean hasNear(Pose2d pose, int end) {
        return IntStream.range(0, end).anyMatch(i -> held[i].pose.isNear(pose, MERGED_METERS, MERGED_RADIANS));
    }

    /// @param motion of the base since the last scan, in its old frame
    /// @param uncertainty of the way
    /// @param step length of the way [m], turns included
    /// @param followed the pose that is followed
    void follow(Pose2d motion, Covariance2d uncertainty, double step, Beams beams, Pose2d followed) {
        for (int i = 0; i < count; i++) {
            held[i].pose = held[i].pose.compose(motion);
        }
        if (beams.count() == 0 || count == 0) {
            return;
        }
        double fit = search.score(beams, followed);
        double best = fit;
        var fits = new double[count];
        for (int i = 0; i < count; i++) {
            held[i].pose = refinement.refine(beams, held[i].pose, uncertainty);
            fits[i] = search.score(beams, held[i].pose);
            best = Math.max(best, fits[i]);
        }
        int kept = 0;
        for (int i = 0; i < count; i++) {
            Challenger one = held[i];
            one.log = Math.min(0, one.log - independentBeams * step / FOLLOWED_METERS * (best - fits[i] - SAME));
            one.way += step;
            one.extent = Math.max(one.extent, one.pose.distanceTo(one.found));
            one.advantage += step * (fits[i] - fit);
            one.see(search.fates(beams, one.pose), step);
            if (one.log > -RULED_OUT
                    && !one.pose.isNear(followed, MERGED_METERS, MERGED_RADIANS)
                    && !hasNear(one.pose, kept)) {
                held[kept++] = one;
            }
        }
        count = kept;
    }

    /// Whether one of them has to be believed as much as the pose that is followed.
    boolean isSerious() {
        return IntStream.range(0, count).anyMatch(i -> held[i].isSerious());
    }

    /// The one that must be right.
    ///
    /// @param followed where the robot is followed
    /// @param drift how far it may be elsewhere by wrong odometry [m]
    /// @param explained share of the beams that end at walls where the robot is followed
    /// @param isRefuted whether scans speak against the pose that is followed
    /// @return none or one
    List<Pose2d> winner(Pose2d followed, double drift, double explained, boolean isRefuted) {
        int near = isRefuted || explained < DOUBTFUL ? bestNear(followed, NEARBY + drift) : -1;
        if (near >= 0) {
            return List.of(held[near].pose);
        }
        int best = -1;
        int serious = 0;
        for (int i = 0; i < count; i++) {
            if (held[i].isSerious()) {
                serious++;
                best = best < 0 || held[i].better() > held[best].better() ? i : best;
            }
        }
        return isRefuted && serious == 1 && wins(held[best], explained) ? List.of(held[best].pose) : List.of();
    }

    /// The best to which odometry may have led.
    private int bestNear(Pose2d followed, double meters) {
        int best = -1;
        for (int i = 0; i < count; i++) {
            Challenger one = held[i];
            if (one.pose.isNear(followed, meters, NEARLY_TURNED)
                    && one.way >= SERIOUS_AFTER
                    && one.better() > NEARBY_BETTER
                    && one.hits >= NEARBY_EXPLAINS
                    && one.through <= CONTRADICTED
                    && (best < 0 || one.better() > held[best].better())) {
                best = i;
            }
        }
        return best;
    }

    private static boolean wins(Challenger one, double explained) {
        double known = share(one, explained);
        return one.way >= between(SHORTEST_WAY, LONGEST_WAY, known)
                && one.extent >= between(LEAST_EXTENT, LARGEST_EXTENT, known)
                && one.better() > MUCH_BETTER;
    }

    /// How much speaks for a room that has changed, and not for a robot that was carried, from 0 to 1.
    private static double share(Challenger one, double explained) {
        double byBeams = (explained - LITTLE_EXPLAINED) / (MUCH_EXPLAINED - LITTLE_EXPLAINED);
        double byFit = (FAR_BETTER - one.better()) / (FAR_BETTER - A_LITTLE_BETTER);
        return Math.clamp(Math.max(byBeams, byFit), 0, 1);
    }

    private static double between(double least, double most, double share) {
        return least + share * (most - least);
    }

    /// A pose that is followed and those that challenge it seriously, each as likely as it.
    List<Hypothesis> join(List<Hypothesis> clusters) {
        List<Hypothesis> serious = IntStream.range(0, count)
                .filter(i -> held[i].isSerious())
                .mapToObj(i -> new Hypothesis(1, held[i].pose, AlternativeHypotheses.SPREAD))
                .limit(9)
                .toList();
        if (serious.isEmpty()) {
            return clusters;
        }
        double share = 1.0 / (1 + serious.size());
        Hypothesis first = clusters.getFirst();
        var all = new java.util.ArrayList<Hypothesis>();
        all.add(new Hypothesis(share, first.mapFromBase(), first.covariance()));
        serious.forEach(one -> all.add(new Hypothesis(share, one.mapFromBase(), one.covariance())));
        return List.copyOf(all);
    }
}
