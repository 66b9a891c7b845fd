package rsal.navigation.avoid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoublePredicate;
import rsal.data.Angles;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.RangeArray;

/// Points around a robot that are not free, in its base frame [m], and how far it sees. Filled again for each step;
/// reused, so that nothing is allocated.
public final class Obstacles {
    private static final double APART = 0.03; // m; points that are nearer to each other say nothing new

    /// Directions of sight, evenly around the base, the first one straight ahead.
    public static final int SIGHTS = 720;

    private static final Point2d ORIGIN = new Point2d(0, 0);

    private final double reach;
    private float[] x = new float[512];
    private float[] y = new float[512];
    private float[] room = new float[512];
    private final List<LaserScan> scans = new ArrayList<>();
    private final float[] sight = new float[SIGHTS];
    private boolean sighted; // sight is that of the scans
    private int count;

    /// @param reach points farther than this from the base are of no interest [m]
    public Obstacles(double reach) {
        this.reach = reach;
    }

    public int count() {
        return count;
    }

    public double x(int i) {
        return x[i];
    }

    public double y(int i) {
        return y[i];
    }

    /// Room to keep from a point beside what is kept from any [m].
    public double room(int i) {
        return room[i];
    }

    /// Keeps more room from a point, as from one that may move.
    public void keepRoom(int i, double meters) {
        room[i] = (float) meters;
    }

    public Point2d at(int i) {
        return new Point2d(x[i], y[i]);
    }

    /// How far from the base nothing is in a direction, by laser scans [m]; 0 where none looks. Worked out when it
    /// is first asked for, since most planners never do.
    ///
    /// @param direction 0 to [#SIGHTS] − 1
    public double sight(int direction) {
        if (!sighted) {
            sighted = true;
            Arrays.fill(sight, 0);
            scans.forEach(this::see);
        }
        return sight[direction];
    }

    public void clear() {
        count = 0;
        scans.clear();
        sighted = false;
    }

    /// A range under the scanner's least counts as that least one; 0 m that are not under it are none.
    public void add(LaserScan scan) {
        Pose2d mount = scan.baseFromLaser();
        double farthest = Math.min(reach + mount.position().distanceTo(ORIGIN), scan.rangeMax());
        for (int i = 0; i < scan.count(); i++) {
            double range = scan.distance(i);
            if (range <= farthest) {
                add(mount, scan.angle(i), range);
            }
        }
        scans.add(scan);
        sighted = false;
    }

    private void see(LaserScan scan) {
        double farthest = Math.min(reach, scan.rangeMax());
        for (int i = 0; i < scan.count(); i++) {
            double range = scan.distance(i);
            if (range > 0) {
                see(scan.baseFromLaser(), scan.angle(i), Math.min(range, farthest));
            }
        }
    }

    /// What two beams see in the same direction is as far as the shorter one.
    private void see(Pose2d mount, double angle, double range) {
        double direction = mount.theta() + angle;
        double px = mount.x() + range * Math.cos(direction);
        double py = mount.y() + range * Math.sin(direction);
        int sector = Math.floorMod((int) Math.round(Math.atan2(py, px) * SIGHTS / (2 * Math.PI)), SIGHTS);
        float far = (float) Math.hypot(px, py);
        sight[sector] = sight[sector] == 0 ? far : Math.min(sight[sector], far);
    }

    /// Each hit counts as three points across its cone.
    public void add(RangeArray sonars) {
        add(sonars, _ -> false);
    }

    /// Only of sonars that look where a laser scan does not reach, or where its beams are broken: at all three points.
    public void addBeside(LaserScan scan, RangeArray sonars) {
        double beside = sonars.fieldOfView() / 3;
        add(
                sonars,
                direction -> covers(scan, direction)
                        && (looks(scan, direction)
                                || looks(scan, direction - beside)
                                || looks(scan, direction + beside)));
    }

    private static boolean covers(LaserScan scan, double direction) {
        return scan.count() > 0 && fromFirst(scan, direction) <= (scan.count() - 1) * scan.angleIncrement();
    }

    /// Whether a laser scan says what is in a direction of the base frame [rad]: it reaches there, and the nearest of
    /// its beams is not broken.
    public static boolean looks(LaserScan scan, double direction) {
        return covers(scan, direction)
                && !Double.isNaN(scan.distance((int) Math.round(fromFirst(scan, direction) / scan.angleIncrement())));
    }

    /// By what angle a direction is counter-clockwise of the first beam [rad].
    private static double fromFirst(LaserScan scan, double direction) {
        double angle = Angles.difference(scan.baseFromLaser().theta() + scan.angleMin(), direction);
        return angle < 0 ? angle + 2 * Math.PI : angle;
    }

    private void add(RangeArray sonars, DoublePredicate covered) {
        for (int i = 0; i < sonars.count(); i++) {
            if (covered.test(sonars.baseFromSensors().get(i).theta())) {
                continue;
            }
            double range = sonars.distance(i);
            if (range <= sonars.rangeMax()) {
                Pose2d mount = sonars.baseFromSensors().get(i);
                add(mount, -sonars.fieldOfView() / 3, range);
                add(mount, 0, range);
                add(mount, sonars.fieldOfView() / 3, range);
            }
        }
    }

    private void add(Pose2d mount, double angle, double range) {
        double direction = mount.theta() + angle;
        add(mount.x() + range * Math.cos(direction), mount.y() + range * Math.sin(direction));
    }

    public void add(double px, double py) {
        boolean near = px * px + py * py <= reach * reach;
        if (!near || (count > 0 && isBesideLast(px, py))) {
            return;
        }
        if (count == x.length) {
            x = Arrays.copyOf(x, 2 * count);
            y = Arrays.copyOf(y, 2 * count);
            room = Arrays.copyOf(room, 2 * count);
        }
        x[count] = (float) px;
        y[count] = (float) py;
        room[count] = 0;
        count++;
    }

    private boolean isBesideLast(double px, double py) {
        double dx = px - x[count - 1];
        double dy = py - y[count - 1];
        return dx * dx + dy * dy < APART * APART;
    }
}
