package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// Finds the poses that fit best to what is known of how they lie to each other: F. Lu, E. Milios, Globally
/// Consistent Range Scan Alignment for Environment Mapping, Autonomous Robots 4 (1997), section 3; G.
/// Grisetti et al., A Tutorial on Graph-Based SLAM, IEEE ITS Magazine 2 (2010), algorithm 1, with the steps
/// of Levenberg and Marquardt.
///
/// Relations that close loops count less the less they fit (P. Agarwal et al., Robust Map Optimization using
/// Dynamic Covariance Scaling, ICRA 2013, equation 15), those of scans and wheels after Huber. The first pose
/// stays.
public final class PoseGraph {
    /// From which square of its error, in deviations, a loop is scaled down ("Φ" in the paper).
    public static final double LOOP_PHI = 5;

    private static final double AFAR_PHI = 1e5; // of loops that are all trusted
    private static final double HUBER = 9; // square of an error, in deviations, from which on a weight falls
    private static final int STEPS = 50;
    private static final double DONE = 1e-5; // share of the error

    private PoseGraph() {}

    /// @param poses mapFrom-poses by number
    /// @param error half the sum of the squared errors in deviations, robust
    /// @param steps it took
    public record Fit(List<Pose2d> poses, double error, int steps) {
        public Fit {
            poses = List.copyOf(poses);
        }
    }

    /// Fits poses of which nothing is known but a guess: first as if loops could be trusted, then ever less,
    /// so that those which are right have pulled the graph together before others are scaled down (after A.
    /// Blake, A. Zisserman, Visual Reconstruction, MIT Press 1987, on graduated non-convexity). A wrong loop
    /// may bend the graph and then fit: who calls this looks at the other relations.
    public static Fit fitFromAfar(List<Pose2d> guess, List<Relation> relations) {
        Fit fit = fit(guess, relations, AFAR_PHI);
        for (double phi = AFAR_PHI / 5; phi > LOOP_PHI; phi /= 5) {
            fit = fit(fit.poses, relations, phi);
        }
        return fit(fit.poses, relations);
    }

    /// @param guess a pose for each number, so good that only wrong loops don't fit
    public static Fit fit(List<Pose2d> guess, List<Relation> relations) {
        return fit(guess, relations, LOOP_PHI);
    }

    private static Fit fit(List<Pose2d> guess, List<Relation> relations, double phi) {
        int count = guess.size();
        if (count < 2 || relations.isEmpty()) {
            return new Fit(guess, 0, 0);
        }
        var pairs = new ArrayList<int[]>();
        for (Relation relation : relations) {
            if (relation.from() > 0 && relation.to() > 0) {
                pairs.add(new int[] {relation.from() - 1, relation.to() - 1});
            }
        }
        var equations = new Blocks(count - 1, pairs);
        double[][] informations = relations.stream().map(PoseGraph::information).toArray(double[][]::new);
        double[] poses = numbers(guess);
        double error = error(poses, relations, informations, phi);
        double damping = 1e-6;
        int step = 0;
        while (step < STEPS) {
            step++;
            linearize(poses, relations, informations, equations, phi);
            equations.addToDiagonal(damping);
            double[] tried = moved(poses, equations.solve());
            double reached = error(tried, relations, informations, phi);
            if (reached <= error) { // not NaN
                double gain = error - reached;
                poses = tried;
                error = reached;
                damping = Math.max(1e-9, damping / 5);
                if (gain <= DONE * error) {
                    break;
                }
            } else {
                damping *= 20;
                if (damping > 1e6) {
                    break;
                }
            }
        }
        return new Fit(poses(poses), error, step);
    }

    /// Square of the error of a relation in deviations, "χ²".
    public static double square(Relation relation, Pose2d mapFromFrom, Pose2d mapFromTo) {
        Pose2d is = mapFromFrom.inverse().compose(mapFromTo);
        Pose2d reported = relation.fromFromTo();
        return square(
                information(relation),
                is.x() - reported.x(),
                is.y() - reported.y(),
                Angles.difference(reported.theta(), is.theta()));
    }

    private static double[] numbers(List<Pose2d> poses) {
        var numbers = new double[3 * poses.size()];
        for (int i = 0; i < poses.size(); i++) {
            numbers[3 * i] = poses.get(i).x();
            numbers[3 * i + 1] = poses.get(i).y();
            numbers[3 * i + 2] = poses.get(i).theta();
        }
        return numbers;
    }

    private static List<Pose2d> poses(double[] numbers) {
        var poses = new ArrayList<Pose2d>();
        for (int i = 0; i < numbers.length; i += 3) {
            poses.add(new Pose2d(numbers[i], numbers[i + 1], numbers[i + 2]));
        }
        return poses;
    }

    private static double[] moved(double[] poses, double[] by) {
        var moved = poses.clone();
        for (int i = 3; i < moved.length; i++) {
            moved[i] += by[i - 3];
        }
        return moved;
    }

    private static double error(double[] poses, List<Relation> relations, double[][] informations, double phi) {
        double sum = 0;
        var off = new double[5];
        for (int i = 0; i < informations.length; i++) {
            off(poses, relations.get(i), off);
            double square = square(informations[i], off[0], off[1], off[2]);
            sum += relations.get(i).source() == Relation.Source.LOOP
                    ? (square <= phi ? square : phi * (3 * square - phi) / (phi + square))
                    : (square <= HUBER ? square : 2 * Math.sqrt(HUBER * square) - HUBER);
        }
        return sum / 2;
    }

    /// How much a relation counts, from the derivative of what [#error] sums up.
    private static double weight(Relation.Source source, double square, double phi) {
        if (source == Relation.Source.LOOP) {
            double scale = Math.min(1, 2 * phi / (phi + square));
            return scale * scale;
        }
        return square <= HUBER ? 1 : Math.sqrt(HUBER / square);
    }

    /// The error of a relation, and the cosine and sine of the first heading.
    private static void off(double[] poses, Relation relation, double[] off) {
        int from = 3 * relation.from();
        int to = 3 * relation.to();
        double cos = Math.cos(poses[from + 2]);
        double sin = Math.sin(poses[from + 2]);
        double dx = poses[to] - poses[from];
        double dy = poses[to + 1] - poses[from + 1];
        off[0] = cos * dx + sin * dy - relation.fromFromTo().x();
        off[1] = -sin * dx + cos * dy - relation.fromFromTo().y();
        off[2] = Angles.wrap(
                poses[to + 2] - poses[from + 2] - relation.fromFromTo().theta());
        off[3] = cos;
        off[4] = sin;
    }

    private static void linearize(
            double[] poses, List<Relation> relations, double[][] informations, Blocks equations, double phi) {
        equations.clear();
        var off = new double[5];
        for (int i = 0; i < informations.length; i++) {
            Relation relation = relations.get(i);
            off(poses, relation, off);
            double weight = weight(relation.source(), square(informations[i], off[0], off[1], off[2]), phi);
            double[] information = scaled(informations[i], weight);
            double cos = off[3];
            double sin = off[4];
            double byTheta0 = off[1] + relation.fromFromTo().y();
            double byTheta1 = -off[0] - relation.fromFromTo().x();
            double[] byFrom = {-cos, -sin, byTheta0, sin, -cos, byTheta1, 0, 0, -1};
            double[] byTo = {cos, sin, 0, -sin, cos, 0, 0, 0, 1};
            if (relation.from() > 0) {
                add(equations, relation.from() - 1, byFrom, information, off);
            }
            if (relation.to() > 0) {
                add(equations, relation.to() - 1, byTo, information, off);
            }
            if (relation.from() > 0 && relation.to() > 0) {
                equations.add(relation.from() - 1, relation.to() - 1, product(byFrom, information, byTo));
            }
        }
    }

    private static void add(Blocks equations, int unknown, double[] by, double[] information, double[] off) {
        equations.add(unknown, unknown, product(by, information, by));
        var pull = new double[3];
        for (int i = 0; i < 3; i++) {
            double weighed =
                    information[3 * i] * off[0] + information[3 * i + 1] * off[1] + information[3 * i + 2] * off[2];
            for (int k = 0; k < 3; k++) {
                pull[k] -= by[3 * i + k] * weighed;
            }
        }
        equations.addRight(unknown, pull[0], pull[1], pull[2]);
    }

    /// aᵀ information b
    private static double[] product(double[] a, double[] information, double[] b) {
        var weighed = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                weighed[3 * i + k] = information[3 * i] * b[k]
                        + information[3 * i + 1] * b[3 + k]
                        + information[3 * i + 2] * b[6 + k];
            }
        }
        var product = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                product[3 * i + k] = a[i] * weighed[k] + a[3 + i] * weighed[3 + k] + a[6 + i] * weighed[6 + k];
            }
        }
        return product;
    }

    private static double[] scaled(double[] information, double by) {
        var scaled = information.clone();
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] *= by;
        }
        return scaled;
    }

    private static double square(double[] information, double x, double y, double theta) {
        return information[0] * x * x
                + information[4] * y * y
                + information[8] * theta * theta
                + 2 * (information[1] * x * y + information[2] * x * theta + information[5] * y * theta);
    }

    private static double[] information(Relation relation) {
        Covariance2d i = relation.covariance().inverse();
        return new double[] {
            i.xx(), i.xy(), i.xTheta(), i.xy(), i.yy(), i.yTheta(), i.xTheta(), i.yTheta(), i.thetaTheta()
        };
    }
}
