package rsal.behavior;

import java.util.ArrayDeque;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// Notices that the robot gets nowhere though it should, and gets it out: first it moves the way that can be held
/// longest without touching anything, backwards rather than forwards, then it turns to where there is most room.
/// It counts updates, one every 0.1 s.
public final class EscapeWhenStuck implements Behavior {
    private static final int UPDATES = 20;
    private static final double DISTANCE = 0.1; // m
    private static final double ANGLE = Math.toRadians(10);
    private static final int MOVE_UPDATES = 15;
    private static final int TURN_UPDATES = 30;
    private static final double TURN_RATE = 0.6; // rad/s
    private static final double[] SPEEDS = {-0.1, 0.1, 0}; // m/s
    private static final double[] TURN_RATES = {0, 0.3, -0.3, TURN_RATE, -TURN_RATE};
    private static final double MARGIN = 0.01; // m
    private static final double HORIZON = 3; // s
    private static final double LOOK_AHEAD = 0.8; // m
    private static final double STEP = Math.toRadians(10);
    private static final double THERE = Math.toRadians(10);

    private final ArrayDeque<Pose2d> odomFromBases = new ArrayDeque<>();
    private final BodyOutline body;
    private int escaping;
    private Pose2d odomFromWayOut = Pose2d.ORIGIN;

    public EscapeWhenStuck(Footprint footprint) {
        this.body = new BodyOutline(footprint);
    }

    @Override
    public String state() {
        return escaping > 0 ? "escaping" : "";
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        Pose2d odomFromBase = percept.odometry().odomFromBase();
        if (escaping == 0) {
            if (isStuck(odomFromBase, below)) {
                escaping = MOVE_UPDATES + TURN_UPDATES;
                odomFromBases.clear();
            } else {
                return below;
            }
        }
        escaping--;
        if (escaping >= TURN_UPDATES) {
            double heading = widest(percept.surroundings());
            odomFromWayOut = odomFromBase.compose(new Pose2d(0, 0, heading));
            return freest(percept.surroundings());
        }
        double off = Angles.difference(odomFromBase.theta(), odomFromWayOut.theta());
        if (Math.abs(off) < THERE) {
            escaping = 0;
            return below;
        }
        return Twist2d.drive(0, Math.copySign(TURN_RATE, off));
    }

    /// A robot that is told to stand still is not stuck.
    private boolean isStuck(Pose2d odomFromBase, Twist2d below) {
        if (below.equals(Twist2d.STOP)) {
            odomFromBases.clear();
        }
        odomFromBases.add(odomFromBase);
        if (odomFromBases.size() <= UPDATES) {
            return false;
        }
        Pose2d odomFromThen = odomFromBases.remove();
        return odomFromThen.isNear(odomFromBase, DISTANCE, ANGLE);
    }

    private Twist2d freest(Surroundings around) {
        double longest = 0;
        Twist2d freest = Twist2d.STOP;
        for (double speed : SPEEDS) {
            for (double turnRate : TURN_RATES) {
                Twist2d twist = Twist2d.drive(speed, turnRate);
                double time = twist.equals(Twist2d.STOP) ? 0 : body.timeToTouch(around, twist, MARGIN, HORIZON);
                if (time > longest) {
                    longest = time;
                    freest = twist;
                }
            }
        }
        return freest;
    }

    private static double widest(Surroundings around) {
        double widest = -1;
        double best = Math.PI;
        for (double heading = -Math.PI; heading < Math.PI; heading += STEP) {
            double clearance = Math.min(2, around.clearance(heading, LOOK_AHEAD));
            if (clearance > widest || (clearance == widest && Math.abs(heading) < Math.abs(best))) {
                widest = clearance;
                best = heading;
            }
        }
        return best;
    }
}
