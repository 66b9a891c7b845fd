package rsal.behavior;

import rsal.data.Angles;

/// How far a robot can see around itself: the distance from the base's origin to the nearest thing in each of
/// [#SECTORS] equal sectors, counter-clockwise from straight behind. +∞ means that nothing is there as far as the
/// sensors go, NaN that none of them looks there.
public final class Surroundings {
    public static final int SECTORS = 180;

    /// Of one sector [rad].
    public static final double WIDTH = 2 * Math.PI / SECTORS;

    /// How near to the border of its sector a place must be for its direction to be computed exactly [sectors]; that of
    /// others is off by a third of that at most.
    private static final double NEAR = 1e-3;

    /// The same, across that border, for places at a distance of 1 m [m].
    private static final double BESIDE = 1e-9;

    private static final double[] COS = new double[SECTORS];
    private static final double[] SIN = new double[SECTORS];
    private static final double[] BORDER_COS = new double[SECTORS + 1]; // of a sector's begin
    private static final double[] BORDER_SIN = new double[SECTORS + 1];

    static {
        for (int i = 0; i < SECTORS; i++) {
            COS[i] = Math.cos(direction(i));
            SIN[i] = Math.sin(direction(i));
        }
        for (int i = 0; i <= SECTORS; i++) {
            BORDER_COS[i] = Math.cos(direction(i) - WIDTH / 2);
            BORDER_SIN[i] = Math.sin(direction(i) - WIDTH / 2);
        }
    }

    private final float[] ranges;
    private final double[] x = new double[SECTORS];
    private final double[] y = new double[SECTORS];
    private int things;

    /// @param ranges one per sector [m]; handed over, not shared
    public Surroundings(float[] ranges) {
        if (ranges.length != SECTORS) {
            throw new IllegalArgumentException(
                    "Surroundings have %d sectors, not %d.".formatted(SECTORS, ranges.length));
        }
        this.ranges = ranges;
        for (int i = 0; i < SECTORS; i++) {
            if (ranges[i] < Float.POSITIVE_INFINITY) {
                x[things] = ranges[i] * COS[i];
                y[things] = ranges[i] * SIN[i];
                things++;
            }
        }
    }

    /// The sector that a direction of the base lies in.
    public static int sector(double bearing) {
        return Math.floorMod((int) Math.floor((Angles.wrap(bearing) + Math.PI) / WIDTH), SECTORS);
    }

    /// The sector that a place lies in, in the base frame [m]: that of `Math.atan2(y, x)`, in a fifth of its time. By
    /// polynomial 4.4.49 of Abramowitz and Stegun, Handbook of Mathematical Functions (1964), for arc tangents,
    /// which is off by 1e-5 rad at most; only places beside a border take longer.
    static int sectorOf(double x, double y) {
        double across = Math.abs(x);
        double along = Math.abs(y);
        double z = Math.min(across, along) / Math.max(across, along);
        double zz = z * z;
        double angle = z * (0.9998660 + zz * (-0.3302995 + zz * (0.1801410 + zz * (-0.0851330 + zz * 0.0208351))));
        if (along > across) {
            angle = Math.PI / 2 - angle;
        }
        if (x < 0) {
            angle = Math.PI - angle;
        }
        double sectors = (Math.PI + (y < 0 ? -angle : angle)) / WIDTH;
        int sector = (int) sectors;
        double beyond = sectors - sector;
        return beyond > NEAR && beyond < 1 - NEAR ? sector : sector(Math.atan2(y, x)); // also of what is no place
    }

    /// The same, at once where a guess is right.
    static int sectorOf(double x, double y, int guess) {
        double beside = BESIDE * (Math.abs(x) + Math.abs(y));
        boolean isRight = BORDER_COS[guess] * y - BORDER_SIN[guess] * x > beside
                && BORDER_SIN[guess + 1] * x - BORDER_COS[guess + 1] * y > beside;
        return isRight ? guess : sectorOf(x, y);
    }

    /// Where the middle of a sector lies, in the base frame [rad].
    public static double direction(int sector) {
        return -Math.PI + (sector + 0.5) * WIDTH;
    }

    /// Cosine of a sector's direction.
    static double cos(int sector) {
        return COS[sector];
    }

    /// Sine of a sector's direction.
    static double sin(int sector) {
        return SIN[sector];
    }

    public float range(int sector) {
        return ranges[sector];
    }

    /// How many sectors have a thing in them.
    public int things() {
        return things;
    }

    /// Where a thing is, in the base frame [m].
    double x(int thing) {
        return x[thing];
    }

    double y(int thing) {
        return y[thing];
    }

    /// The shortest range between two directions, counter-clockwise from the first to the second; +∞ when nothing
    /// is seen there.
    public double nearest(double from, double to) {
        int last = sector(to);
        double nearest = Double.POSITIVE_INFINITY;
        for (int sector = sector(from); ; sector = (sector + 1) % SECTORS) {
            if (ranges[sector] < nearest) {
                nearest = ranges[sector];
            }
            if (sector == last) {
                return nearest;
            }
        }
    }

    /// How wide a disc may be to get from here to a place straight away: its largest radius [m], +∞ when nothing
    /// is in the way. Things that it leaves behind do not count, however near they are.
    ///
    /// @param heading in the base frame [rad]
    /// @param distance of the place [m]
    public double clearance(double heading, double distance) {
        double cos = Math.cos(heading);
        double sin = Math.sin(heading);
        double clearance = Double.POSITIVE_INFINITY;
        for (int i = 0; i < things; i++) {
            double ahead = cos * x[i] + sin * y[i];
            if (ahead <= 0) {
                continue;
            }
            double aside = Math.abs(cos * y[i] - sin * x[i]);
            double beyond = Math.max(0, ahead - distance);
            if (beyond == 0) {
                clearance = Math.min(clearance, aside);
            } else if (aside < clearance && beyond < clearance) {
                clearance = Math.min(clearance, Math.sqrt(aside * aside + beyond * beyond));
            }
        }
        return clearance;
    }
}
