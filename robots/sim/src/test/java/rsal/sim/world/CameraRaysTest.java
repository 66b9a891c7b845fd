package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.robot.Shift;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.testkit.LongTest;

class CameraRaysTest {
    private static final Footprint BOX = RandomWorld.box(0.5, 0.4, 0, 0);
    private static final double HEIGHT = 0.3; // of the camera above its base
    private static final double ROUNDING = 1e-9;

    /// What a pixel shows.
    ///
    /// @param distance to where its ray meets that, seen from above [m]
    private record Shown(@Nullable Surface surface, double distance) {
        static final Shown NOTHING = new Shown(null, Double.POSITIVE_INFINITY);

        Shown or(Surface other, double itsWay) {
            return itsWay < distance ? new Shown(other, itsWay) : this;
        }

        boolean isSame(Shown other) {
            return Objects.equals(surface, other.surface)
                    && (surface == null || Math.abs(distance - other.distance) < 1e-6);
        }
    }

    /// One ray a pixel, which asks everything there is.
    private record Eye(World world, List<Body> others, Pose2d mapFromCamera, double z, double reach, boolean all) {
        /// @param elevation upwards [rad]
        Shown look(double direction, double elevation) {
            if (Math.abs(elevation) >= Math.PI / 2) {
                return Shown.NOTHING;
            }
            double dx = Math.cos(direction);
            double dy = Math.sin(direction);
            double slope = Math.tan(elevation);
            Shown shown = Shown.NOTHING;
            for (RasterWalls walls : world.walls()) {
                double enters = entersLayer(slope, walls.lowest() - z, walls.highest() - z);
                double leaves = leavesLayer(slope, walls.lowest() - z, walls.highest() - z);
                double most = Math.min(reach, leaves);
                if (enters <= most) {
                    double x = mapFromCamera.x() + enters * dx;
                    double y = mapFromCamera.y() + enters * dy;
                    double range = RandomWorld.ray(walls, x, y, dx, dy, most - enters);
                    shown = range <= most - enters ? shown.or(walls.surface(), enters + range) : shown;
                }
            }
            for (Body body : others) {
                for (PlacedShape piece : body.seen.pieces) {
                    double enters = entersLayer(slope, piece.low() - z, piece.high() - z);
                    double leaves = leavesLayer(slope, piece.low() - z, piece.high() - z);
                    double most = Math.min(reach, leaves);
                    // from the side that it leaves, backwards, to see how far it is in there
                    double far = 1000;
                    double from = piece.ray(mapFromCamera.x(), mapFromCamera.y(), dx, dy);
                    double to = far - piece.ray(mapFromCamera.x() + far * dx, mapFromCamera.y() + far * dy, -dx, -dy);
                    double distance = Math.max(from, enters);
                    shown = distance <= Math.min(to, most) ? shown.or(piece.surface, distance) : shown;
                }
            }
            return shown.surface != null && (all || shown.surface.blob()) ? shown : Shown.NOTHING;
        }

        /// Whether a pixel shows the same a hair beside, and no two things that it is inside of, of which either will
        /// do.
        boolean isSure(Shown shown, double direction, double elevation) {
            for (double aside : new double[] {-ROUNDING, ROUNDING}) {
                for (double up : new double[] {-ROUNDING, ROUNDING}) {
                    if (!shown.isSame(look(direction + aside, elevation + up))) {
                        return false;
                    }
                }
            }
            return shown.distance > 0;
        }

        /// How far a ray is when it comes to heights above the camera; +∞ when it never does.
        private static double entersLayer(double slope, double low, double high) {
            if (low <= 0 && 0 < high) {
                return 0;
            }
            double distance = (low > 0 ? low : high) / slope;
            return distance >= 0 ? distance : Double.POSITIVE_INFINITY;
        }

        private static double leavesLayer(double slope, double low, double high) {
            double distance = (slope > 0 ? high : low) / slope;
            return distance >= 0 ? distance : Double.POSITIVE_INFINITY;
        }
    }

    private static RasterWalls walls(RandomWorld random, double lowest, double highest) {
        var solid = new BitSet();
        for (int i = 0; i < random.map.cells().length; i++) {
            solid.set(i, random.random.nextDouble() < 0.01);
        }
        var surface = new Surface(new Rgb(1, 2, 3), true, 1, random.random.nextBoolean(), 0, 0, false);
        return new RasterWalls(new SolidRaster(
                random.map.width(),
                random.map.height(),
                solid,
                random.map.originX() + 0.1 * random.random.nextDouble(), // in no line with others
                random.map.originY() + 0.1 * random.random.nextDouble(),
                random.map.resolution(),
                random.map.resolution(),
                lowest,
                highest,
                random.random.nextBoolean(),
                surface));
    }

    /// Walls around the camera's height, below it and above it, by turns.
    private static List<RasterWalls> walls(RandomWorld random, long seed) {
        var walls = new ArrayList<RasterWalls>();
        if (seed % 4 == 0) {
            walls.add(RasterWalls.of(random.map));
        }
        if (seed % 3 > 0) {
            walls.add(walls(random, -0.4, random.random.nextDouble(-0.3, 1)));
        }
        if (seed % 5 > 2) {
            walls.add(walls(random, 0.8, random.random.nextDouble(0.9, 2)));
        }
        return walls;
    }

    private static World world(RandomWorld random, long seed) {
        List<RasterWalls> walls = walls(random, seed);
        var extent = new Extent(
                random.map.originX(),
                random.map.originY(),
                random.map.originX() + random.map.width() * random.map.resolution(),
                random.map.originY() + random.map.height() * random.map.resolution());
        return new World(walls, extent);
    }

    private static List<Body> bodies(World world, RandomWorld random) {
        var bodies = new ArrayList<Body>();
        for (int i = 0; i < 25; i++) {
            double height = i == 0 ? 0 : random.random.nextDouble(-0.5, 1.5);
            bodies.add(world.add("b" + i, random.chunks(), random.anywhere(), height));
        }
        world.look();
        return bodies;
    }

    /// Of a pinhole, whatever it is, with its depth.
    @Test
    @LongTest
    void everyPixelOfAPinholeIsPaintedWithWhatItsRayMeetsFirst() {
        int shown = 0;
        int unsure = 0;
        for (long seed = 0; seed < 150; seed++) {
            var random = new RandomWorld(seed, 0.1, 0.005);
            World world = world(random, seed);
            List<Body> bodies = bodies(world, random);
            Body self = bodies.getFirst();
            var pinhole = new CameraRays.Pinhole(
                    random.random.nextInt(1, 60), random.random.nextInt(1, 60), random.random.nextDouble(3, 60));
            double reach = random.random.nextDouble(0.5, 6);
            var shift = seed % 2 == 0 ? Shift.NONE : new Shift(new Pose2d(0.5, 0.1, 0.3), 0.2);
            var baseFromCamera = new Pose2d(0.1, 0.1, 1);
            Pose2d from = self.pose().compose(shift.baseFromMoved()).compose(baseFromCamera);
            var eye = new Eye(world, bodies.subList(1, bodies.size()), from, HEIGHT + shift.rise(), reach, true);
            int[] colors = new int[pinhole.columns() * pinhole.rows()];
            float[] depths = new float[colors.length];
            Arrays.fill(colors, -1);
            new CameraRays(baseFromCamera, pinhole, HEIGHT).paint(world, self, shift, reach, colors, depths);
            for (int pixel = 0; pixel < colors.length; pixel++) {
                double left = (pinhole.columns() / 2.0 - pixel % pinhole.columns() - 0.5) / pinhole.focalLength();
                int row = pixel / pinhole.columns();
                double up = (pinhole.rows() / 2.0 - row - 0.5) / pinhole.focalLength();
                double direction = from.theta() + Math.atan(left);
                double elevation = Math.atan2(up, Math.hypot(1, left));
                Shown right = eye.look(direction, elevation);
                if (eye.isSure(right, direction, elevation)) {
                    int color = right.surface == null
                            ? -1
                            : Integer.decode(right.surface.color().toString());
                    assertThat(colors[pixel])
                            .as("seed %d, pixel %d", seed, pixel)
                            .isEqualTo(color);
                    if (right.surface != null) {
                        double depth = right.distance / Math.hypot(1, left);
                        assertThat(depths[pixel]).isCloseTo((float) depth, within(1e-4f));
                    }
                } else {
                    unsure += right.distance == 0 ? 0 : 1;
                }
                shown += right.surface == null ? 0 : 1;
            }
        }
        assertThat(shown).isGreaterThan(20_000);
        assertThat(unsure).isLessThan(shown / 20);
    }

    @Test
    void everyPixelShowsWhatItsRayMeetsFirst() {
        int shown = 0;
        int beside = 0;
        int unsure = 0;
        for (long seed = 0; seed < 150; seed++) {
            var random = new RandomWorld(seed, 0.1, 0.005);
            World world = world(random, seed);
            List<Body> bodies = bodies(world, random);
            Body self = bodies.getFirst();
            int columns = random.random.nextInt(1, 60);
            int rows = random.random.nextInt(1, 60);
            double fieldOfView = random.random.nextDouble(0.1, 6.28);
            double reach = random.random.nextDouble(0.5, 6);
            var shift = seed % 2 == 0 ? Shift.NONE : new Shift(new Pose2d(0.5, 0.1, 0.3), 0.2);
            var baseFromCamera = new Pose2d(0.1, 0.1, 1);
            Pose2d from = self.pose().compose(shift.baseFromMoved()).compose(baseFromCamera);
            var eye = new Eye(world, bodies.subList(1, bodies.size()), from, HEIGHT + shift.rise(), reach, false);
            var sight =
                    new CameraRays(baseFromCamera, columns, rows, fieldOfView, HEIGHT).look(world, self, shift, reach);
            int[][] patches = patches(sight, columns, rows);
            double apart = fieldOfView / columns;
            double[] distances = new double[sight.count()]; // NaN where that is not sure
            for (int column = 0; column < columns; column++) {
                Surface above = null;
                for (int row = 0; row < rows; row++) {
                    double direction = from.theta() + fieldOfView / 2 - (column + 0.5) * apart;
                    double elevation = (rows / 2.0 - row - 0.5) * apart;
                    Shown right = eye.look(direction, elevation);
                    int patch = patches[column][row];
                    boolean sure = eye.isSure(right, direction, elevation);
                    if (sure) {
                        assertThat(patch < 0 ? null : sight.surface(patch))
                                .as("seed %d, column %d, row %d", seed, column, row)
                                .isEqualTo(right.surface);
                    }
                    if (patch >= 0) {
                        distances[patch] += sure ? right.distance : Double.NaN;
                    }
                    shown += right.surface == null ? 0 : 1;
                    unsure += sure || right.distance == 0 ? 0 : 1;
                    beside += above != null && right.surface != null && !right.surface.equals(above) ? 1 : 0;
                    above = right.surface;
                }
            }
            for (int i = 0; i < distances.length; i++) {
                assertThat(Double.isNaN(distances[i]) || Math.abs(sight.distances(i) - distances[i]) < 1e-6)
                        .as("seed %d, patch %d: %s", seed, i, distances[i])
                        .isTrue();
            }
        }
        assertThat(shown).isGreaterThan(20_000);
        assertThat(beside).isGreaterThan(500);
        assertThat(unsure).isLessThan(shown / 20);
    }

    /// The patch that each pixel is in; -1 in none.
    private static int[][] patches(ColumnRenderer sight, int columns, int rows) {
        int[][] patches = new int[columns][rows];
        for (int[] column : patches) {
            Arrays.fill(column, -1);
        }
        int before = -1;
        for (int i = 0; i < sight.count(); i++) {
            assertThat(sight.column(i) * rows + sight.first(i))
                    .as("column by column, from above")
                    .isGreaterThan(before);
            assertThat(sight.end(i)).isGreaterThan(sight.first(i));
            Arrays.fill(patches[sight.column(i)], sight.first(i), sight.end(i), i);
            before = sight.column(i) * rows + sight.end(i) - 1;
        }
        return patches;
    }

    /// How far what is in the middle of a view is; +∞ when nothing is.
    private static double ahead(World world, Body self) {
        ColumnRenderer sight = new CameraRays(Pose2d.ORIGIN, 1, 1, 0.1, 0).look(world, self, 9);
        return sight.count() == 0 ? Double.POSITIVE_INFINITY : sight.distances(0);
    }

    @Test
    void looksThroughItselfAndWhatItCarries() {
        var world = new World(List.of(), new Extent(0, 0, 10, 10));
        Body self = world.add("self", CollisionShape.of(BOX), new Pose2d(2, 5, 0), 0);
        Body held = world.add("held", CollisionShape.of(BOX), new Pose2d(4, 5, 0), 0);
        Body other = world.add("other", CollisionShape.of(BOX), new Pose2d(8, 5, Math.PI), 0);
        assertThat(ahead(world, self)).isCloseTo(1.75, within(1e-9));
        world.pickUp(held, self);
        world.look();
        assertThat(ahead(world, self)).isCloseTo(5.75, within(1e-9));
        assertThat(ahead(world, other)).isCloseTo(3.75, within(1e-9));
        world.carry(held, new Pose2d(5, 5, 0), 0);
        assertThat(ahead(world, other)).isCloseTo(3.75, within(1e-9));
        world.look();
        assertThat(ahead(world, other)).isCloseTo(2.75, within(1e-9));
    }

    @Test
    void seesOverWhatIsLow() {
        var world = new World(List.of(), new Extent(0, 0, 10, 10));
        Body self = world.add("self", CollisionShape.of(BOX), new Pose2d(2, 5, 0), 0);
        world.add("puck", prism(0.1, 1), new Pose2d(2.55, 5, 0), 0);
        world.add("box", prism(0.6, 2), new Pose2d(5.1, 5, 0), 0);
        ColumnRenderer sight = new CameraRays(Pose2d.ORIGIN, 1, 60, Math.toRadians(1), HEIGHT).look(world, self, 9);
        assertThat(sight.count()).isEqualTo(2);
        assertThat(sight.surface(0).fiducial()).isEqualTo(2);
        assertThat(sight.first(0)).isEqualTo(24); // 0.3 m higher, 3 m away: 5.7°
        assertThat(sight.end(0)).isEqualTo(36); // it stands on the floor
        assertThat(sight.surface(1).fiducial()).isEqualTo(1);
        assertThat(sight.first(1)).isEqualTo(47); // the far edge of its top: 0.2 m lower, 0.65 m away, 17.1°
        assertThat(sight.end(1)).isEqualTo(60);
    }

    private static List<CollisionShape> prism(double height, int fiducial) {
        List<Point2d> corners = RandomWorld.box(0.2, 0.2, 0, 0).corners();
        return List.of(
                new CollisionShape.Prism(new ConvexOutline(corners), 0, height, Surface.PLAIN.withMarker(fiducial)));
    }
}
