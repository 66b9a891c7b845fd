package rsal.navigation.slam;

import java.util.BitSet;
import java.util.List;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;

/// Finds out whether a scan looks through what others hit, as it does when it is put to a wrong place.
final class Transparency {
    private static final double CELL = 0.1; // m
    private static final double SHORT = 0.3; // m; before a hit
    private static final int MOST_CELLS = 1 << 24;
    private static final int LOOKED = 24; // scans of many

    private final double originX;
    private final double originY;
    private final int width;
    private final int height;
    private final BitSet hit;

    Transparency(Cloud reference) {
        double leastX = Double.POSITIVE_INFINITY;
        double leastY = Double.POSITIVE_INFINITY;
        double mostX = Double.NEGATIVE_INFINITY;
        double mostY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < reference.count(); i++) {
            leastX = Math.min(leastX, reference.x(i));
            leastY = Math.min(leastY, reference.y(i));
            mostX = Math.max(mostX, reference.x(i));
            mostY = Math.max(mostY, reference.y(i));
        }
        originX = reference.count() == 0 ? 0 : leastX;
        originY = reference.count() == 0 ? 0 : leastY;
        width = reference.count() == 0 ? 1 : (int) ((mostX - leastX) / CELL) + 1;
        height = (int) Math.min((double) MOST_CELLS / width, (Math.max(mostY, originY) - originY) / CELL + 1);
        hit = new BitSet(width * height);
        for (int i = 0; i < reference.count(); i++) {
            int cell = cell(reference.x(i), reference.y(i));
            if (cell >= 0) {
                hit.set(cell);
            }
        }
    }

    private int cell(double x, double y) {
        double column = Math.floor((x - originX) / CELL);
        double row = Math.floor((y - originY) / CELL);
        return column >= 0 && column < width && row >= 0 && row < height ? (int) (row * width + column) : -1;
    }

    /// Share of the beams of some of many scans, evenly chosen, that went through something.
    ///
    /// @param mapFromBases of the scans
    double through(List<GraphNode> frames, List<Pose2d> mapFromBases, Pose2d referenceFromMap) {
        int looked = Math.min(LOOKED, frames.size());
        double sum = 0;
        for (int i = 0; i < looked; i++) {
            int frame = (int) ((i + 0.5) * frames.size() / looked);
            sum += through(frames.get(frame), referenceFromMap.compose(mapFromBases.get(frame)));
        }
        return sum / looked;
    }

    /// Share of the beams of a scan that went through something.
    double through(GraphNode frame, Pose2d referenceFromBase) {
        Pose2d from = referenceFromBase.compose(frame.scan().baseFromLaser());
        Cloud cloud = frame.cloud().movedBy(referenceFromBase);
        int through = 0;
        for (int i = 0; i < cloud.count(); i++) {
            double dx = cloud.x(i) - from.x();
            double dy = cloud.y(i) - from.y();
            double length = Math.hypot(dx, dy);
            for (double along = SHORT; along < length - SHORT; along += CELL) {
                int cell = cell(from.x() + along / length * dx, from.y() + along / length * dy);
                if (cell >= 0 && hit.get(cell)) {
                    through++;
                    break;
                }
            }
        }
        return (double) through / Math.max(1, cloud.count());
    }
}
