package rsal.sim.world;

import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.robot.Shift;
import rsal.scene.Surface;

/// What a camera looks at: a level ray for each column of its image. It ends at the first thing of which a part is
/// neither above nor below the image where the ray meets it, whatever the camera's own height; nothing is transparent.
/// (Stage looks at all heights, and so a sheet on the floor would hide what is behind it.) Robots of one kind share it.
public final class View {
    private final double x; // of the camera in the base frame [m]
    private final double y;
    private final double height; // above the base [m]
    private final double slope; // of the upper border of the image, height over way
    private final double[] cos; // of each column, in the base frame
    private final double[] sin;

    /// What is in each column of an image, from left to right.
    public static final class Sight {
        private final double[] range;
        private final double[] low;
        private final double[] high;
        private final @Nullable Surface[] surface;

        private Sight(int columns) {
            range = new double[columns];
            low = new double[columns];
            high = new double[columns];
            surface = new @Nullable Surface[columns];
        }

        /// [m]; +∞ when nothing is there.
        public double range(int column) {
            return range[column];
        }

        /// Lower end above the camera [m].
        public double low(int column) {
            return low[column];
        }

        /// Upper end above the camera [m].
        public double high(int column) {
            return high[column];
        }

        /// Null when nothing is there.
        public @Nullable Surface surface(int column) {
            return surface[column];
        }

        private void put(int column, double way, double lowest, double highest, Surface its) {
            range[column] = way;
            low[column] = lowest;
            high[column] = highest;
            surface[column] = its;
        }
    }

    /// Columns and rows are the same angle apart.
    ///
    /// @param height of the camera above the base [m]
    public View(Pose2d baseFromCamera, int columns, int rows, double fieldOfView, double height) {
        this.x = baseFromCamera.x();
        this.y = baseFromCamera.y();
        this.height = height;
        double apart = fieldOfView / columns;
        double up = rows * apart / 2;
        this.slope = up < Math.PI / 2 ? StrictMath.tan(up) : Double.POSITIVE_INFINITY;
        cos = new double[columns];
        sin = new double[columns];
        for (int i = 0; i < columns; i++) {
            double angle = baseFromCamera.theta() + fieldOfView / 2 - (i + 0.5) * apart;
            cos[i] = StrictMath.cos(angle);
            sin[i] = StrictMath.sin(angle);
        }
    }

    public int columns() {
        return cos.length;
    }

    /// What there is as [World#look] saw it.
    ///
    /// @param self whose camera it is, where sensors see it; rays pass through it
    public Sight look(World world, Body self, double reach) {
        return look(world, self, Shift.NONE, reach);
    }

    /// The same, of a camera that has been carried along.
    public Sight look(World world, Body self, Shift shift, double reach) {
        Figure base = self.seen.shifted(shift);
        double z = base.height() + height;
        Rays rays = Rays.ofThisThread(cos.length);
        double fromX = base.pose().x() + base.cos() * x - base.sin() * y;
        double fromY = base.pose().y() + base.sin() * x + base.cos() * y;
        for (int i = 0; i < cos.length; i++) {
            rays.x[i] = fromX;
            rays.y[i] = fromY;
            rays.dx[i] = base.cos() * cos[i] - base.sin() * sin[i];
            rays.dy[i] = base.sin() * cos[i] + base.cos() * sin[i];
            rays.range[i] = Double.POSITIVE_INFINITY;
            rays.met[i] = Rays.NOTHING;
        }
        endAtPieces(world, self, rays, z, reach);
        var sight = new Sight(cos.length);
        for (int i = 0; i < cos.length; i++) {
            sight.range[i] = rays.range[i];
            if (rays.met[i] != Rays.NOTHING) {
                Piece piece = world.seen(rays.met[i]);
                sight.put(i, rays.range[i], piece.low() - z, piece.high() - z, piece.surface);
            }
        }
        for (Walls walls : world.walls()) {
            if (walls.isAt(z)) {
                walls.end(rays, reach);
                for (int i = 0; i < cos.length; i++) {
                    if (rays.range[i] < sight.range[i]) {
                        sight.put(i, rays.range[i], walls.lowest() - z, walls.highest() - z, walls.surface());
                    }
                }
            }
        }
        return sight;
    }

    private void endAtPieces(World world, Body self, Rays rays, double z, double reach) {
        PieceGrid.Found near = rays.near;
        world.seenNear(rays.x[0], rays.y[0], reach, near);
        for (int k = 0; k < near.count; k++) {
            int slot = near.slots[k];
            Piece piece = world.seen(slot);
            if (world.seenOwner(slot) == self) {
                continue;
            }
            double least = Math.max(0, Math.max(piece.low() - z, z - piece.high())) / slope;
            double square = piece.radius() * piece.radius();
            for (int i = 0; i < cos.length; i++) {
                double aside = (piece.x() - rays.x[i]) * rays.dy[i] - (piece.y() - rays.y[i]) * rays.dx[i];
                if (aside * aside <= square) {
                    double range = piece.ray(rays.x[i], rays.y[i], rays.dx[i], rays.dy[i]);
                    if (range < rays.range[i] && range <= reach && range >= least) {
                        rays.range[i] = range;
                        rays.met[i] = slot;
                    }
                }
            }
        }
    }
}
