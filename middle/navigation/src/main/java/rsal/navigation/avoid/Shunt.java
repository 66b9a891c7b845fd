package rsal.navigation.avoid;

import java.util.List;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.MultiPointTurn.Leg;

/// Drives the legs that [MultiPointTurn] found, one after the other, by odometry. Each robot needs its own.
public final class Shunt {
    private static final double STEERING = 2; // 1/s; turn rate per angle that is missing
    private static final double THERE = Math.toRadians(2);
    private static final double SLOW = 0.5; // rad/s; in place

    private final List<Leg> legs;
    private final double speed;
    private int leg;
    private double distance; // made of the leg [m]
    private double heading; // where the leg began, as it was planned, by odometry
    private Pose2d last;

    /// @param speed to drive at [m/s]
    /// @param odomFromBase where it begins
    public Shunt(List<Leg> legs, double speed, Pose2d odomFromBase) {
        this.legs = List.copyOf(legs);
        this.speed = speed;
        this.last = odomFromBase;
        this.heading = odomFromBase.theta();
    }

    /// How long all of it takes, about [s].
    public double seconds() {
        return legs.stream()
                .mapToDouble(l -> 1 + Math.max(Math.abs(l.meters()) / speed, Math.abs(l.radians()) / SLOW))
                .sum();
    }

    /// Whether it is through.
    public boolean done() {
        return leg == legs.size();
    }

    /// What to command now; to be asked at each beat.
    public Twist2d drive(Motion motion) {
        distance += last.distanceTo(motion.odomFromBase());
        last = motion.odomFromBase();
        while (leg < legs.size()) {
            Leg now = legs.get(leg);
            double length = Math.abs(now.meters());
            double share = length == 0 ? 1 : Math.min(1, distance / length);
            double missing = Angles.difference(last.theta(), heading + share * now.radians());
            if (length == 0 ? Math.abs(missing) > THERE : share < 1) {
                return length == 0
                        ? Twist2d.drive(0, Math.clamp(STEERING * missing, -SLOW, SLOW))
                        : Twist2d.drive(
                                Math.copySign(speed, now.meters()),
                                speed * now.radians() / length + STEERING * missing);
            }
            leg++;
            distance = 0;
            heading += now.radians();
        }
        return Twist2d.STOP;
    }
}
