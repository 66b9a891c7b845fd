package rsal.sim.device;

import java.time.Instant;
import java.util.Arrays;
import rsal.device.DeviceInfo;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.device.camera.CameraKind;
import rsal.robot.RobotModel.Part;
import rsal.settings.Arguments;

/// Makes simulated cameras. They see walls, robots and things, each in one color, without light and shadow; the
/// floor is gray, and above the horizon it is bright where nothing is.
public final class SimCameraKind implements SimulatedKind {
    @Override
    public Class<Camera> makes() {
        return Camera.class;
    }

    @Override
    public SimulatedSensor<CameraImage> create(DeviceInfo info, Part.Registered part, SimulatedRobot robot) {
        return new SimCamera(info, part.arguments(), robot);
    }

    private static final class SimCamera extends SimulatedSensor<CameraImage> implements Camera {
        private static final int FLOOR = 0xb8b4aa;
        private static final int ABOVE = 0xe6eef5;

        private final SimulatedRobot robot;
        private final int columns;
        private final int rows;
        private final double focalLength; // px
        private final double range; // m
        private final double view; // m
        private final double noise; // 1/m
        private final int[] colors; // 0xRRGGBB
        private final float[] depths; // m

        SimCamera(DeviceInfo info, Arguments arguments, SimulatedRobot robot) {
            super(info);
            this.robot = robot;
            this.columns = arguments.get(CameraKind.COLUMNS);
            this.rows = arguments.get(CameraKind.ROWS);
            this.focalLength = CameraKind.focalLength(arguments);
            this.range = arguments.get(CameraKind.RANGE);
            this.view = arguments.get(CameraKind.VIEW);
            this.noise = robot.noise() * arguments.get(CameraKind.DEPTH_NOISE);
            this.colors = new int[columns * rows];
            this.depths = new float[columns * rows];
        }

        @Override
        public int rays() {
            return columns;
        }

        @Override
        public CameraImage measure(Instant now) {
            paintAir();
            robot.paint(columns, rows, focalLength, view, colors, depths);
            paintFloor();
            byte[] rgb = new byte[3 * colors.length];
            byte[] depth = new byte[2 * colors.length];
            for (int i = 0; i < colors.length; i++) {
                rgb[3 * i] = (byte) (colors[i] >> 16);
                rgb[3 * i + 1] = (byte) (colors[i] >> 8);
                rgb[3 * i + 2] = (byte) colors[i];
                int millimeters = millimeters(depths[i]);
                depth[2 * i] = (byte) millimeters;
                depth[2 * i + 1] = (byte) (millimeters >> 8);
            }
            return new CameraImage(columns, rows, focalLength, rgb, depth);
        }

        private void paintAir() {
            Arrays.fill(colors, ABOVE);
            Arrays.fill(depths, Float.POSITIVE_INFINITY);
        }

        /// A row below the horizon sees the floor where its ray meets it, at the same depth in all columns,
        /// unless something is nearer. Walls of maps reach below the floor.
        private void paintFloor() {
            for (int row = rows / 2; row < rows; row++) {
                double down = (row + 0.5 - rows / 2.0) / focalLength;
                if (down > 0) {
                    paintFloor(row, (float) (robot.height() / down));
                }
            }
        }

        private void paintFloor(int row, float depth) {
            for (int pixel = row * columns; pixel < (row + 1) * columns; pixel++) {
                if (depths[pixel] > depth) {
                    depths[pixel] = depth;
                    colors[pixel] = FLOOR;
                }
            }
        }

        private int millimeters(double depth) {
            if (!(depth <= range)) {
                return 0;
            }
            double measured = noise == 0
                    ? depth
                    : depth + noise * depth * depth * robot.random().nextGaussian();
            return Math.clamp(Math.round(1000 * measured), 1, 65_535);
        }
    }
}
