package rsal.sim.world;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
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
public final class CameraRays {
    private final double x; // of the camera in the base frame [m]
    private final double y;
    private final double height; // above the base [m]
    private final ColumnRenderer.Optics optics;
    private final @Nullable Pinhole pinhole;
    private final double[] cos; // of each column, in the base frame
    private final double[] sin;

    /// @param height of the camera above the base [m]
    public CameraRays(Pose2d baseFromCamera, int columns, int rows, double fieldOfView, double height) {
        this.x = baseFromCamera.x();
        this.y = baseFromCamera.y();
        this.height = height;
        double apart = fieldOfView / columns;
        int above = 0;
        while (above < rows / 2 && elevation(above, rows, apart) >= Math.PI / 2) {
            above++;
        }
        double[] slopes = new double[rows - 2 * above];
        for (int i = 0; i < slopes.length; i++) {
            slopes[i] = StrictMath.tan(elevation(above + i, rows, apart));
        }
        double[] stretch = new double[columns];
        Arrays.fill(stretch, 1);
        pinhole = null;
        optics = new ColumnRenderer.Optics(apart, new double[0], stretch, above, slopes);
        cos = new double[columns];
        sin = new double[columns];
        for (int i = 0; i < columns; i++) {
            double angle = baseFromCamera.theta() + fieldOfView / 2 - (i + 0.5) * apart;
            cos[i] = StrictMath.cos(angle);
            sin[i] = StrictMath.sin(angle);
        }
    }

    /// Of a camera without distortion, which looks along its x axis.
    ///
    /// @param height of the camera above the base [m]
    public CameraRays(Pose2d baseFromCamera, Pinhole pinhole, double height) {
        x = baseFromCamera.x();
        y = baseFromCamera.y();
        this.height = height;
        this.pinhole = pinhole;
        int columns = pinhole.columns();
        double[] slopes = new double[pinhole.rows()];
        for (int i = 0; i < slopes.length; i++) {
            slopes[i] = (pinhole.rows() / 2.0 - i - 0.5) / pinhole.focalLength();
        }
        cos = new double[columns];
        sin = new double[columns];
        double[] stretch = new double[columns];
        double[] clockwise = new double[columns];
        double first = StrictMath.atan((columns / 2.0 - 0.5) / pinhole.focalLength());
        for (int i = 0; i < columns; i++) {
            double aside = (columns / 2.0 - i - 0.5) / pinhole.focalLength();
            double left = StrictMath.atan(aside);
            cos[i] = StrictMath.cos(baseFromCamera.theta() + left);
            sin[i] = StrictMath.sin(baseFromCamera.theta() + left);
            stretch[i] = Math.sqrt(1 + aside * aside);
            clockwise[i] = first - left;
        }
        optics = new ColumnRenderer.Optics(0, clockwise, stretch, 0, slopes);
    }

    /// Whether it is that of such a camera.
    public boolean isOf(Pinhole other) {
        return other.equals(pinhole);
    }

    /// A camera without distortion: the ray of column c and row r goes (columns / 2 - c - 1/2) / f to the left and
    /// (rows / 2 - r - 1/2) / f upwards for each meter ahead.
    ///
    /// @param focalLength f [px]
    public record Pinhole(int columns, int rows, double focalLength) {}

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
        return look(world, self, shift, reach, false);
    }

    /// Paints all that there is, blobs or not, over what is in two arrays.
    ///
    /// @param colors by pixel, row by row: 0xRRGGBB
    /// @param depths by pixel, along the optical axis [m]
    public void paint(World world, Body self, Shift shift, double reach, int[] colors, float[] depths) {
        look(world, self, shift, reach, true).paint(colors, depths);
    }

    private ColumnRenderer look(World world, Body self, Shift shift, double reach, boolean all) {
        Figure base = self.seen.shifted(shift);
        double z = base.height() + height;
        ColumnRenderer sight = ColumnRenderer.ofThisThread(optics, z, reach);
        if (all) {
            sight.keepAll();
        }
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
