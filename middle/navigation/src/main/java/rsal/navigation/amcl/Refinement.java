package rsal.navigation.amcl;

import java.util.Arrays;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.navigation.grid.DistanceField;

/// Moves a pose to where a scan fits the map best nearby: Gauss-Newton on the distances of the beams' ends to the
/// nearest wall, interpolated between cells, as S. Kohlbrecher and others do with probabilities (A Flexible and
/// Scalable SLAM System with Full 3D Motion Estimation, SSRR 2011, equations 4 to 12).
///
/// Differs from the paper in that distances are smooth farther from the walls than probabilities are; in that a
/// beam counts the less the farther it ends from all walls (S. Geman, D. McClure, Statistical Methods for
/// Tomographic Image Reconstruction, 1987), since people are not on the map; and in that the pose it starts from
/// counts as a measurement of its own, so that it stays where the scan tells nothing, as along a corridor.
///
/// Allocates nothing per call but the answer. Not safe for several threads at once.
final class Refinement {
    private static final int STEPS = 12;
    private static final double DONE_METERS = 1e-4;
    private static final double DONE_RADIANS = 1e-4;
    private static final double FARTHEST = 0.5; // m, from the start
    private static final double MOST_TURN = 0.3; // rad, the same

    private final DistanceField toWall;
    private final double deviation;
    private final double independentBeams;
    private final double[] slope = new double[3]; // distance, and how it grows along x and y
    private final double[] sums = new double[9]; // upper triangle of the information, row by row, and its right side

    /// @param toWall how far the nearest place is where a beam may end
    /// @param deviation how far hits are from the walls of the map [m]
    /// @param independentBeams number of independent beams for which a scan counts
    Refinement(DistanceField toWall, double deviation, double independentBeams) {
        this.toWall = toWall;
        this.deviation = deviation;
        this.independentBeams = independentBeams;
    }

    /// @param uncertainty of the start, without the scan
    /// @return the start itself when there is nothing better near
    Pose2d refine(Beams beams, Pose2d start, Covariance2d uncertainty) {
        int count = beams.count();
        if (count == 0) {
            return start;
        }
        double scale = Math.min(1, independentBeams / count) / (deviation * deviation);
        double priorX = 1 / Math.max(1e-6, uncertainty.xx());
        double priorY = 1 / Math.max(1e-6, uncertainty.yy());
        double priorTheta = 1 / Math.max(1e-6, uncertainty.thetaTheta());
        double x = start.x();
        double y = start.y();
        double theta = start.theta();
        for (int step = 0; step < STEPS; step++) {
            add(beams, x, y, theta, scale);
            double a = sums[0] + priorX;
            double b = sums[1];
            double c = sums[2];
            double d = sums[3] + priorY;
            double e = sums[4];
            double f = sums[5] + priorTheta;
            double u = sums[6] + priorX * (start.x() - x);
            double v = sums[7] + priorY * (start.y() - y);
            double w = sums[8] + priorTheta * Angles.difference(theta, start.theta());
            // Cholesky: the prior keeps it positive definite
            double l11 = Math.sqrt(a);
            double l21 = b / l11;
            double l31 = c / l11;
            double l22 = Math.sqrt(Math.max(1e-12, d - l21 * l21));
            double l32 = (e - l31 * l21) / l22;
            double l33 = Math.sqrt(Math.max(1e-12, f - l31 * l31 - l32 * l32));
            double z1 = u / l11;
            double z2 = (v - l21 * z1) / l22;
            double z3 = (w - l31 * z1 - l32 * z2) / l33;
            double dTheta = z3 / l33;
            double dy = (z2 - l32 * dTheta) / l22;
            double dx = (z1 - l21 * dy - l31 * dTheta) / l11;
            x += dx;
            y += dy;
            theta += dTheta;
            if (!(Math.hypot(x - start.x(), y - start.y()) <= FARTHEST
                    && Math.abs(Angles.difference(start.theta(), theta)) <= MOST_TURN)) {
                return start;
            }
            if (Math.abs(dx) < DONE_METERS && Math.abs(dy) < DONE_METERS && Math.abs(dTheta) < DONE_RADIANS) {
                break;
            }
        }
        return new Pose2d(x, y, theta);
    }

    private void add(Beams beams, double x, double y, double theta, double scale) {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        double near = 4 * deviation * deviation;
        Arrays.fill(sums, 0);
        float[] beamX = beams.x();
        float[] beamY = beams.y();
        for (int i = 0; i < beamX.length; i++) {
            double turnedX = cos * beamX[i] - sin * beamY[i];
            double turnedY = sin * beamX[i] + cos * beamY[i];
            if (!toWall.slope(x + turnedX, y + turnedY, slope)) {
                continue;
            }
            double distance = slope[0];
            double share = near / (near + distance * distance);
            double weight = scale * share * share;
            double gx = slope[1];
            double gy = slope[2];
            double gTheta = gy * turnedX - gx * turnedY;
            sums[0] += weight * gx * gx;
            sums[1] += weight * gx * gy;
            sums[2] += weight * gx * gTheta;
            sums[3] += weight * gy * gy;
            sums[4] += weight * gy * gTheta;
            sums[5] += weight * gTheta * gTheta;
            sums[6] -= weight * gx * distance;
            sums[7] -= weight * gy * distance;
            sums[8] -= weight * gTheta * distance;
        }
    }
}
