package rsal.sim.world;

import rsal.data.Pose2d;
import rsal.robot.Shift;

/// What a camera looks at: a ray for each pixel of its image, which ends at whatever it meets first; nothing is
/// transparent. The rays of a column are in one upright plane, those of a row rise as steeply, and columns and rows are
/// the same angle φ apart, the horizon in the middle of the image: the ray of column c and row r goes by
/// (columns / 2 − c − ½) φ to the left and by (rows / 2 − r − ½) φ upwards. A row beyond the zenith or below the feet
/// shows nothing. Robots of one kind share it.
///
/// Every piece is a rectangle in the plane of a column, and so it is rows one above the other whose rays meet it. Which
/// of several a row meets first is settled row by row, where there is something to tell of (z-buffer: Catmull, A
/// Subdivision Algorithm for Computer Display of Curved Surfaces, 1974).
public final class View {
    private final double x; // of the camera in the base frame [m]
    private final double y;
    private final double height; // above the base [m]
    private final double apart; // columns, and rows [rad]
    private final int rowsAbove; // beyond the zenith
    private final double[] slopes; // of the rows under those, height over way, from the highest to the lowest
    private final double[] cos; // of each column, in the base frame
    private final double[] sin;

    /// @param height of the camera above the base [m]
    public View(Pose2d baseFromCamera, int columns, int rows, double fieldOfView, double height) {
        this.x = baseFromCamera.x();
        this.y = baseFromCamera.y();
        this.height = height;
        apart = fieldOfView / columns;
        int above = 0;
        while (above < rows / 2 && elevation(above, rows, apart) >= Math.PI / 2) {
            above++;
        }
        rowsAbove = above;
        slopes = new double[rows - 2 * above];
        for (int i = 0; i < slopes.length; i++) {
            slopes[i] = StrictMath.tan(elevation(rowsAbove + i, rows, apart));
        }
        cos = new double[columns];
        sin = new double[columns];
        for (int i = 0; i < columns; i++) {
            double angle = baseFromCamera.theta() + fieldOfView / 2 - (i + 0.5) * apart;
            cos[i] = StrictMath.cos(angle);
            sin[i] = StrictMath.sin(angle);
        }
    }

    private static double elevation(int row, int rows, double apart) {
        return (rows / 2.0 - row - 0.5) * apart;
    }

    public int columns() {
        return cos.length;
    }

    /// What there is as [World#look] saw it.
    ///
    /// @param self whose camera it is, where sensors see it; rays pass through it
    /// @param reach how far away things are seen at most, as seen from above [m]
    /// @return overwritten by this thread's next look
    public ColumnRenderer look(World world, Body self, double reach) {
        return look(world, self, Shift.NONE, reach);
    }

    /// The same, of a camera that has been carried along.
    public ColumnRenderer look(World world, Body self, Shift shift, double reach) {
        Figure base = self.seen.shifted(shift);
        double z = base.height() + height;
        ColumnRenderer sight = ColumnRenderer.ofThisThread(cos.length, apart, rowsAbove, slopes, z, reach);
        sight.fromX = base.pose().x() + base.cos() * x - base.sin() * y;
        sight.fromY = base.pose().y() + base.sin() * x + base.cos() * y;
        for (int i = 0; i < cos.length; i++) {
            sight.dx[i] = base.cos() * cos[i] - base.sin() * sin[i];
            sight.dy[i] = base.sin() * cos[i] + base.cos() * sin[i];
        }
        sight.meetPieces(world, self);
        sight.meetWalls(world.walls());
        sight.see(world.walls());
        return sight;
    }
}
