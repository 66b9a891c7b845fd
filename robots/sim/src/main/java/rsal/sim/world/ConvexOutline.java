package rsal.sim.world;

import java.util.List;
import rsal.data.Point2d;

/// A convex outline in its body's frame, as corners and as half planes, of which each edge's outward normal and offset
/// make one. Bodies of one make share it, so that it stays in the processor's cache.
public final class ConvexOutline {
    final int count;
    final double[] x; // of corners
    final double[] y;
    final double[] normalX; // of the edge from the corner of the same index to the next
    final double[] normalY;
    final double[] offset; // of the edge: normal · corner
    final double middleX; // of the box around it
    final double middleY;
    final double radius; // of the circle around the middle that holds it [m]
    final double farthest; // from the frame's origin [m]

    /// @param corners counter-clockwise; some may be in a line, none twice
    public ConvexOutline(List<Point2d> corners) {
        count = corners.size();
        x = new double[count];
        y = new double[count];
        normalX = new double[count];
        normalY = new double[count];
        offset = new double[count];
        double left = Double.POSITIVE_INFINITY;
        double bottom = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            Point2d from = corners.get(i);
            Point2d to = corners.get((i + 1) % count);
            double length = from.distanceTo(to);
            x[i] = from.x();
            y[i] = from.y();
            normalX[i] = (to.y() - from.y()) / length;
            normalY[i] = (from.x() - to.x()) / length;
            offset[i] = normalX[i] * from.x() + normalY[i] * from.y();
            left = Math.min(left, from.x());
            bottom = Math.min(bottom, from.y());
            right = Math.max(right, from.x());
            top = Math.max(top, from.y());
        }
        middleX = (left + right) / 2;
        middleY = (bottom + top) / 2;
        var middle = new Point2d(middleX, middleY);
        radius = corners.stream().mapToDouble(middle::distanceTo).max().orElseThrow();
        farthest = corners.stream()
                .mapToDouble(corner -> Math.hypot(corner.x(), corner.y()))
                .max()
                .orElseThrow();
    }
}
