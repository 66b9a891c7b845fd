package rsal.navigation.amcl;

import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;

/// How likely a beam ends in each cell of a map: S. Thrun, W. Burgard, D. Fox, Probabilistic Robotics (2005),
/// table 6.3, as a table of logarithms. Immutable; robots that share a map share its field.
///
/// Differs from the book in that beams that hit nothing are skipped, not given z_max; that the likelihood is
/// scaled to 1 (logarithm 0) where the map has its walls; and in what lies outside the map ([Outside]). The share of
/// random readings (z_rand) bounds how much one beam can say, so that people and robots who are not on the map do
/// little harm.
public final class LikelihoodField implements SensorModel {
    private static final double FARTHEST = 8; // deviations, where the density has no weight left

    private final int width;
    private final int height;
    private final double originX;
    private final double originY;
    private final double cellsPerMeter;
    private final float unlikely;
    private final float[] logs;
    private final Outside around;

    /// @param toWall how far the nearest place is where a beam may end
    /// @param deviation how far hits are from the walls of the map, σ_hit in the book [m]
    /// @param randomShare of readings that have nothing to do with the map, z_rand in the book
    public LikelihoodField(OccupancyGrid map, DistanceField toWall, double deviation, double randomShare) {
        this.width = map.width();
        this.height = map.height();
        this.originX = map.originX();
        this.originY = map.originY();
        this.cellsPerMeter = 1 / map.resolution();
        this.unlikely = (float) Math.log(randomShare);
        this.around = Outside.of(map);
        this.logs = new float[width * height];
        for (int i = 0; i < logs.length; i++) {
            double deviations = toWall.at(i) / deviation;
            if (deviations > FARTHEST) { // nearly everywhere on a map, and costly to compute
                logs[i] = unlikely;
                continue;
            }
            logs[i] = (float) Math.log((1 - randomShare) * Math.exp(-deviations * deviations / 2) + randomShare);
        }
    }

    /// Logarithm of the likelihood of a beam that can't be explained by the map: the least a beam can have.
    public double unlikely() {
        return unlikely;
    }

    /// Logarithm of the likelihood that a beam ends at a place in the map frame.
    public double log(double x, double y) {
        return logAt((float) ((x - originX) * cellsPerMeter), (float) ((y - originY) * cellsPerMeter));
    }

    @Override
    public double log(Beams beams, double x, double y, double theta) {
        float cos = (float) (Math.cos(theta) * cellsPerMeter);
        float sin = (float) (Math.sin(theta) * cellsPerMeter);
        float baseX = (float) ((x - originX) * cellsPerMeter);
        float baseY = (float) ((y - originY) * cellsPerMeter);
        float[] beamX = beams.x();
        float[] beamY = beams.y();
        float sum = 0;
        for (int i = 0; i < beamX.length; i++) {
            sum += logAt(baseX + cos * beamX[i] - sin * beamY[i], baseY + sin * beamX[i] + cos * beamY[i]);
        }
        if (!around.isUnknown()) {
            return sum;
        }
        int outside = outside(beams, baseX, baseY, cos, sin);
        float beyond = outside * unlikely;
        return around.joined(sum - beyond, beams.count() - outside, beyond, outside);
    }

    private int outside(Beams beams, float baseX, float baseY, float cos, float sin) {
        float[] beamX = beams.x();
        float[] beamY = beams.y();
        int outside = 0;
        for (int i = 0; i < beamX.length; i++) {
            float column = baseX + cos * beamX[i] - sin * beamY[i];
            float row = baseY + sin * beamX[i] + cos * beamY[i];
            outside += isOnMap((int) column, (int) row) ? 0 : 1;
        }
        return outside;
    }

    /// The same where the beams are already turned and in cells, and the base stands on a cell. Looks no further
    /// once the sum, which only falls, is below `enough`.
    float log(float[] turnedX, float[] turnedY, float column, float row, float enough) {
        float sum = 0;
        for (int i = 0; i < turnedX.length && sum > enough; i++) {
            sum += logAt(column + turnedX[i], row + turnedY[i]);
        }
        return sum;
    }

    private float logAt(float column, float row) {
        // A negative number that is cut to 0 is less than a cell outside: not worth a floor.
        int c = (int) column;
        int r = (int) row;
        return isOnMap(c, r) ? logs[r * width + c] : unlikely;
    }

    private boolean isOnMap(int column, int row) {
        return column >= 0 && column < width && row >= 0 && row < height;
    }
}
