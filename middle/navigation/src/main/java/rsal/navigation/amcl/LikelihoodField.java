package rsal.navigation.amcl;

import java.util.Arrays;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;

/// How likely a beam ends in each cell of a map: S. Thrun, W. Burgard, D. Fox, Probabilistic Robotics (2005),
/// table 6.3, as a table of logarithms. Immutable; robots that share a map share its field.
///
/// Differs from the book in that beams that hit nothing are skipped, not given z_max; that the likelihood is
/// scaled to 1 (logarithm 0) where the map has its walls; and in what lies outside the map ([OutOfMapModel]).
/// The share of random readings (z_rand) bounds how much one beam can say, so that people and robots who are
/// not on the map do little harm.
public final class LikelihoodField implements SensorModel {
    private static final double FARTHEST = 8; // deviations, where the density has no weight left

    private final int width;
    private final int height;
    private final double originX;
    private final double originY;
    private final double cellsPerMeter;
    private final float unlikely;
    private final float[] logs; // row by row, with a border of one cell for all that is outside the map
    private final OutOfMapModel around;

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
        this.around = OutOfMapModel.of(map);
        this.logs = new float[(width + 2) * (height + 2)];
        Arrays.fill(logs, unlikely);
        for (int i = 0; i < width * height; i++) {
            double deviations = toWall.at(i) / deviation;
            if (deviations > FARTHEST) { // nearly everywhere on a map, and costly to compute
                continue;
            }
            logs[cell(i % width, i / width)] =
                    (float) Math.log((1 - randomShare) * Math.exp(-deviations * deviations / 2) + randomShare);
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
        int outside = 0;
        for (int i = 0; i < beamX.length; i++) {
            int column = (int) (baseX + cos * beamX[i] - sin * beamY[i]);
            int row = (int) (baseY + sin * beamX[i] + cos * beamY[i]);
            sum += logs[cell(column, row)];
            outside += outside(column, row);
        }
        return joined(sum, beams.count(), outside);
    }

    /// The same for the poses of all particles, to the last bit. Takes one beam of many particles after the other,
    /// not one particle after the other. The ends of a beam then depend on nothing but each other's place in an
    /// array, so that the compiler makes vectors of them; and as particles lie together, so do the cells in which
    /// a beam ends, which the processor's fastest cache then holds.
    void logs(Beams beams, Particles particles, PoseBlock block, double[] into) {
        for (int first = 0; first < particles.count; first += PoseBlock.SIZE) {
            int count = Math.min(PoseBlock.SIZE, particles.count - first);
            block.take(particles, first, count, originX, originY, cellsPerMeter);
            for (int beam = 0; beam < beams.count(); beam++) {
                end(beams.x()[beam], beams.y()[beam], block, count);
                lookUp(block.cell, block.sum, count);
                if (around.isUnknown()) {
                    leave(beams.x()[beam], beams.y()[beam], block, count);
                }
            }
            for (int i = 0; i < count; i++) {
                into[first + i] = joined(block.sum[i], beams.count(), block.outside[i]);
            }
        }
    }

    /// In which cells a beam ends.
    private void end(float beamX, float beamY, PoseBlock block, int count) {
        float[] baseX = block.x;
        float[] baseY = block.y;
        float[] cos = block.cos;
        float[] sin = block.sin;
        int[] cell = block.cell;
        for (int i = 0; i < count; i++) {
            cell[i] = cell((int) (baseX[i] + cos[i] * beamX - sin[i] * beamY), (int)
                    (baseY[i] + sin[i] * beamX + cos[i] * beamY));
        }
    }

    private void lookUp(int[] cell, float[] sum, int count) {
        float[] logs = this.logs;
        for (int i = 0; i < count; i++) {
            sum[i] += logs[cell[i]];
        }
    }

    /// For which poses a beam leaves the map.
    private void leave(float beamX, float beamY, PoseBlock block, int count) {
        float[] baseX = block.x;
        float[] baseY = block.y;
        float[] cos = block.cos;
        float[] sin = block.sin;
        int[] outside = block.outside;
        for (int i = 0; i < count; i++) {
            outside[i] += outside((int) (baseX[i] + cos[i] * beamX - sin[i] * beamY), (int)
                    (baseY[i] + sin[i] * beamX + cos[i] * beamY));
        }
    }

    private double joined(float sum, int count, int outside) {
        if (!around.isUnknown()) {
            return sum;
        }
        float beyond = outside * unlikely;
        return around.joined(sum - beyond, count - outside, beyond, outside);
    }

    private float logAt(float column, float row) {
        return logOf((int) column, (int) row);
    }

    /// Logarithm of the likelihood that a beam ends in a cell, which may be outside the map.
    float logOf(int column, int row) {
        return logs[cell(column, row)];
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /// Where in the table a cell is; those outside the map are the border. A negative coordinate that was cut to 0 is
    /// less than a cell outside: not worth a floor.
    private int cell(int column, int row) {
        int c = Math.min(Math.max(column, -1), width) + 1;
        int r = Math.min(Math.max(row, -1), height) + 1;
        return r * (width + 2) + c;
    }

    /// 1 outside the map, else 0, without a branch, as what is done to vectors needs it: one of the differences is
    /// negative.
    private int outside(int column, int row) {
        return (column | width - 1 - column | row | height - 1 - row) >>> 31;
    }
}
