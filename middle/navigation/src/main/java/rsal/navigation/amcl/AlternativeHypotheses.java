package rsal.navigation.amcl;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate.Hypothesis;

/// Where else the robot may be: poses that fitted a scan, followed by odometry and [Refinement] for as long as scans
/// do not rule them out. Particles forget: of two places that look the same, chance lets one die out. Rivals don't,
/// which is what keeps a localizer honest in symmetric corridors.
///
/// Multiple hypotheses that are tracked apart are P. Jensfelt, S. Kristensen, Active Global Localization for a Mobile
/// Robot Using Multiple Hypothesis Tracking (IEEE Transactions on Robotics and Automation 17, 2001). Differs in that
/// they come from scan matches, and that a rival is not charged for fitting a little worse ([#SAME]): the map's cells
/// make that much difference between places that look the same.
///
/// Not safe for several threads at once.
final class AlternativeHypotheses {
    static final int MOST = 160;

    /// How far around a rival the robot may be [m].
    static final double DEVIATION = 0.1;

    /// The same of its heading [rad].
    static final double TURN_DEVIATION = 0.05;

    static final Covariance2d SPREAD = Covariance2d.ofDeviations(DEVIATION, DEVIATION, TURN_DEVIATION);
    private static final int MOST_TOLD = 10;
    private static final double SAME = 0.15; // mean logarithm of a beam's likelihood
    private static final double RULED_OUT = 12; // logarithm of how many times less likely
    private static final double MERGED_METERS = 0.25;
    private static final double MERGED_RADIANS = 0.15;

    private final GlobalSearch search;
    private final Refinement refinement;
    private final double independentBeams;
    private final Pose2d[] poses = new Pose2d[MOST];
    private final double[] logs = new double[MOST]; // 0 for the best
    private final double[] fits = new double[MOST];
    private int count;

    AlternativeHypotheses(GlobalSearch search, Refinement refinement, double independentBeams) {
        this.search = search;
        this.refinement = refinement;
        this.independentBeams = independentBeams;
    }

    int count() {
        return count;
    }

    void clear() {
        count = 0;
    }

    /// Takes up a place unless it is one of them already.
    ///
    /// @param log of how likely it is, the best so far being 0
    void add(Pose2d pose, double log) {
        if (nearest(pose, MERGED_METERS, MERGED_RADIANS) >= 0) {
            return;
        }
        int at = count < MOST ? count++ : worst();
        poses[at] = pose;
        logs[at] = log;
    }

    private int worst() {
        int worst = 0;
        for (int i = 1; i < count; i++) {
            worst = logs[i] < logs[worst] ? i : worst;
        }
        return worst;
    }

    /// @param motion of the base since the last scan, in its old frame
    /// @param uncertainty of the way
    void follow(Pose2d motion, Covariance2d uncertainty, Beams beams) {
        for (int i = 0; i < count; i++) {
            poses[i] = poses[i].compose(motion);
        }
        if (beams.count() == 0) {
            return;
        }
        double best = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            poses[i] = refinement.refine(beams, poses[i], uncertainty);
            fits[i] = search.score(beams, poses[i]);
            best = Math.max(best, fits[i]);
        }
        double likeliest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            logs[i] -= independentBeams * Math.max(0, best - fits[i] - SAME);
            likeliest = Math.max(likeliest, logs[i]);
        }
        int kept = 0;
        for (int i = 0; i < count; i++) {
            double log = logs[i] - likeliest;
            if (log < -RULED_OUT) {
                continue;
            }
            int same = nearestBefore(kept, poses[i]);
            if (same >= 0) {
                logs[same] = Math.max(logs[same], log);
                continue;
            }
            poses[kept] = poses[i];
            logs[kept] = log;
            kept++;
        }
        count = kept;
    }

    private int nearestBefore(int end, Pose2d pose) {
        for (int i = 0; i < end; i++) {
            if (poses[i].isNear(pose, MERGED_METERS, MERGED_RADIANS)) {
                return i;
            }
        }
        return -1;
    }

    private int nearest(Pose2d pose, double meters, double radians) {
        int nearest = -1;
        for (int i = 0; i < count; i++) {
            if (poses[i].isNear(pose, meters, radians)
                    && (nearest < 0 || pose.distanceTo(poses[i]) < pose.distanceTo(poses[nearest]))) {
                nearest = i;
            }
        }
        return nearest;
    }

    boolean hasNear(Pose2d pose, double meters, double radians) {
        return nearest(pose, meters, radians) >= 0;
    }

    /// Likelihood of all that are near a pose, together 1 with that of all others.
    double share(Pose2d pose, double meters, double radians) {
        double near = 0;
        double all = 0;
        for (int i = 0; i < count; i++) {
            double likelihood = Math.exp(logs[i]);
            all += likelihood;
            near += poses[i].isNear(pose, meters, radians) ? likelihood : 0;
        }
        return all > 0 ? near / all : 0;
    }

    /// All places that are still held, heaviest first: clusters of particles, each as heavy as its particles or
    /// the rivals near it are, and rivals that have no particles. The first cluster stays the first, as heavy as
    /// both its particles and its rivals allow; what others are heavier than it, or than the rest of the belief,
    /// is cut off.
    ///
    /// @param clusters heaviest first, weights summing to 1 at most
    List<Hypothesis> join(List<Hypothesis> clusters, double meters, double radians) {
        if (count == 0) {
            return clusters;
        }
        Hypothesis first = clusters.getFirst();
        double firstWeight = Math.min(first.weight(), share(first.mapFromBase(), meters, radians));
        var others = new ArrayList<Hypothesis>();
        for (Hypothesis cluster : clusters.subList(1, clusters.size())) {
            double weight = Math.max(cluster.weight(), share(cluster.mapFromBase(), meters, radians));
            others.add(new Hypothesis(weight, cluster.mapFromBase(), cluster.covariance()));
        }
        double all =
                IntStream.range(0, count).mapToDouble(i -> Math.exp(logs[i])).sum();
        for (int i = 0; i < count; i++) {
            Pose2d pose = poses[i];
            if (clusters.stream().noneMatch(c -> pose.isNear(c.mapFromBase(), meters, radians))) {
                others.add(new Hypothesis(Math.exp(logs[i]) / all, pose, SPREAD));
            }
        }
        double weight = others.stream().mapToDouble(Hypothesis::weight).sum();
        double scale = Math.min(1, (1 - firstWeight) / weight);
        return Stream.concat(
                        Stream.of(new Hypothesis(firstWeight, first.mapFromBase(), first.covariance())),
                        others.stream()
                                .map(h -> new Hypothesis(
                                        Math.min(firstWeight, scale * h.weight()), h.mapFromBase(), h.covariance()))
                                .sorted(Comparator.comparingDouble(Hypothesis::weight)
                                        .reversed()))
                .limit(MOST_TOLD)
                .toList();
    }

    /// The likeliest; there must be one.
    Pose2d best() {
        int best = 0;
        for (int i = 1; i < count; i++) {
            best = logs[i] > logs[best] ? i : best;
        }
        return poses[best];
    }
}
