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
    private final double[] change = new double[3]; // along x and y, and of the heading

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
            sums[0] += priorX;
            sums[3] += priorY;
            sums[5] += priorTheta;
            sums[6] += priorX * (start.x() - x);
            sums[7] += priorY * (start.y() - y);
            sums[8] += priorTheta * Angles.difference(theta, start.theta());
            solve(sums, change);
            double dx = change[0];
            double dy = change[1];
            double dTheta = change[2];
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

    /// Solves three linear equations of a symmetric, positive definite matrix, which the prior makes it: by Cholesky.
    ///
    /// @param sums upper triangle of the matrix, row by row, and the right side
    /// @param into gets the solution
    static void solve(double[] sums, double[] into) {
        double l11 = Math.sqrt(sums[0]);
        double l21 = sums[1] / l11;
        double l31 = sums[2] / l11;
        double l22 = Math.sqrt(Math.max(1e-12, sums[3] - l21 * l21));
        double l32 = (sums[4] - l31 * l21) / l22;
        double l33 = Math.sqrt(Math.max(1e-12, sums[5] - l31 * l31 - l32 * l32));
        double z1 = sums[6] / l11;
        double z2 = (sums[7] - l21 * z1) / l22;
        double z3 = (sums[8] - l31 * z1 - l32 * z2) / l33;
        into[2] = z3 / l33;
        into[1] = (z2 - l32 * into[2]) / l22;
        into[0] = (z1 - l21 * into[1] - l31 * into[2]) / l11;
    }

    /// Sums up what a scan tells about a pose, as [#refine] counts it.
    double[] add(Beams beams, Pose2d pose) {
        double scale = Math.min(1, independentBeams / beams.count()) / (deviation * deviation);
        return add(beams, pose.x(), pose.y(), pose.theta(), scale);
    }

    /// Sums up what beams tell about a pose: the upper triangle of the information, row by row, and its right side.
    /// They hold until the next call.
    double[] add(Beams beams, double x, double y, double theta, double scale) {
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
        return sums;
    }
}
