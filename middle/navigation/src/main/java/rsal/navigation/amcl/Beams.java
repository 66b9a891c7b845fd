package rsal.navigation.amcl;

import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;

/// What was hit by the beams that localization looks at: end points [m] in the base frame, one after the other,
/// and where the sensors were.
///
/// @param x of the end points
/// @param y the same
/// @param originX of the sensor that sent the beam, in the base frame [m]
/// @param originY the same
/// @param cone opening angle of the beams [rad]; 0 for those of a laser
public record Beams(float[] x, float[] y, float[] originX, float[] originY, double cone) {

    /// Of a laser.
    public Beams(float[] x, float[] y, float[] originX, float[] originY) {
        this(x, y, originX, originY, 0);
    }

    public int count() {
        return x.length;
    }

    /// Of a scan at most `count` beams, evenly spread. Beams that hit nothing, are too close or broken, or reach
    /// beyond `maxRange` [m] say nothing about walls and are left out.
    public static Beams of(LaserScan scan, int count, double maxRange) {
        int wanted = Math.min(count, scan.count());
        var builder = new Builder(wanted);
        for (int i = 0; i < wanted; i++) {
            int beam = wanted == 1 ? 0 : (int) ((long) i * (scan.count() - 1) / (wanted - 1));
            if (scan.isHit(beam) && scan.ranges()[beam] <= maxRange) {
                builder.add(scan.baseFromLaser(), scan.angle(beam), scan.ranges()[beam]);
            }
        }
        return builder.build(0);
    }

    /// Of a round of sonars all that hit something within `maxRange` [m], each as a beam along the middle of its
    /// cone.
    public static Beams of(RangeArray sonars, double maxRange) {
        var builder = new Builder(sonars.count());
        for (int i = 0; i < sonars.count(); i++) {
            if (sonars.isHit(i) && sonars.ranges()[i] <= maxRange) {
                builder.add(sonars.baseFromSensors().get(i), 0, sonars.ranges()[i]);
            }
        }
        return builder.build(sonars.fieldOfView());
    }

    private static final class Builder {
        private final float[] x;
        private final float[] y;
        private final float[] originX;
        private final float[] originY;
        private int count;

        Builder(int capacity) {
            x = new float[capacity];
            y = new float[capacity];
            originX = new float[capacity];
            originY = new float[capacity];
        }

        void add(Pose2d baseFromSensor, double angle, double range) {
            double direction = baseFromSensor.theta() + angle;
            x[count] = (float) (baseFromSensor.x() + range * Math.cos(direction));
            y[count] = (float) (baseFromSensor.y() + range * Math.sin(direction));
            originX[count] = (float) baseFromSensor.x();
            originY[count] = (float) baseFromSensor.y();
            count++;
        }

        Beams build(double cone) {
            return new Beams(
                    java.util.Arrays.copyOf(x, count),
                    java.util.Arrays.copyOf(y, count),
                    java.util.Arrays.copyOf(originX, count),
                    java.util.Arrays.copyOf(originY, count),
                    cone);
        }
    }
}
