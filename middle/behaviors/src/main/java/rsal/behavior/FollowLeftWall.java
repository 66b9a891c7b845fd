package rsal.behavior;

import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// Follows the wall on its left, into rooms and out of them; without a wall it goes straight until it meets one.
///
/// It heads for the leftmost direction in which it sees that there is room, right of the wall: directions are
/// tried from the leftmost thing near it to far right. The first run of them that is wide enough for the robot to
/// turn around in is taken, and in that run the first one that keeps the wall's distance, or else the widest.
/// Where there is none it turns right on the spot. A narrow door is thus passed through its middle, a corner
/// rounded at the wall's distance, a dead end left the way it was entered, and a wall met on the wrong side is
/// turned to.
///
/// An island (a table, a pillar) would keep it for ever: after more than a whole turn to the left around
/// something it goes straight on and looks for another wall, as in the Pledge algorithm (H. Abelson, A. diSessa,
/// Turtle Geometry, 1981, ch. 4.2).
public final class FollowLeftWall implements Behavior {
    private static final double WALL_LEFTMOST = Math.toRadians(150);
    private static final double WALL_RIGHTMOST = Math.toRadians(-90);
    private static final double FAR_LEFT = Math.toRadians(110);
    private static final double FAR_RIGHT = Math.toRadians(-180);
    private static final double STEP = Math.toRadians(5);
    private static final double LOOK_AHEAD = 0.8; // m
    private static final double MARGIN = 0.05; // m around the circle that the robot turns in
    private static final double NO_SPEED_FROM = Math.toRadians(60);
    private static final double GAIN = 2; // rad/s per rad
    private static final double TURN_RATE = 1; // rad/s
    private static final double LOST = 1.0; // m beyond the wall's distance
    private static final double SEARCH_DISTANCE = 1.0; // m until a wall beside counts again
    private static final double ISLAND = Math.toRadians(450);

    private final double speed;
    private final double wallDistance;
    private final double room;
    private final double reach;
    private State state = State.SEARCHING;
    private @Nullable Pose2d odomFromLast;
    private double turned;
    private double searched = SEARCH_DISTANCE;

    private enum State {
        SEARCHING,
        FOLLOWING
    }

    /// @param speed where there is room [m/s]
    /// @param wallDistance from the base's origin to the wall [m]
    public FollowLeftWall(Footprint footprint, double speed, double wallDistance) {
        this.speed = speed;
        this.room = footprint.circumscribedRadius() + MARGIN;
        this.wallDistance = Math.max(wallDistance, room);
        this.reach = this.wallDistance + LOST;
    }

    @Override
    public String state() {
        return state == State.SEARCHING ? "searching" : "following";
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        keepCount(percept.odometry().odomFromBase());
        Surroundings around = percept.surroundings();
        boolean blocked = around.clearance(0, LOOK_AHEAD) < room;
        double beside = around.nearest(0, WALL_LEFTMOST);
        switch (state) {
            case SEARCHING -> {
                if (blocked || (searched >= SEARCH_DISTANCE && beside < wallDistance + LOST / 2)) {
                    state = State.FOLLOWING;
                    turned = 0;
                }
            }
            case FOLLOWING -> {
                if (!blocked && (turned > ISLAND || beside > reach)) {
                    state = State.SEARCHING;
                    searched = 0;
                }
            }
        }
        return towards(state == State.SEARCHING ? 0 : leftmost(around));
    }

    private Twist2d towards(double heading) {
        double forward = speed * Math.max(0, 1 - Math.abs(heading) / NO_SPEED_FROM);
        return Twist2d.drive(forward, Math.clamp(GAIN * heading, -TURN_RATE, TURN_RATE));
    }

    private double leftmost(Surroundings around) {
        double widest = 0;
        double best = FAR_RIGHT;
        boolean inRun = false;
        for (double heading = Math.min(FAR_LEFT, wall(around)); heading >= FAR_RIGHT; heading -= STEP) {
            boolean seen = !Float.isNaN(around.range(Surroundings.sector(heading)));
            double clearance = seen ? around.clearance(heading, LOOK_AHEAD) : 0;
            if (clearance >= wallDistance) {
                return heading;
            }
            if (clearance >= room) {
                inRun = true;
            } else if (inRun) {
                return best;
            }
            if (clearance > widest) {
                widest = clearance;
                best = heading;
            }
        }
        return best;
    }

    /// Where the leftmost thing within reach is.
    private double wall(Surroundings around) {
        for (double bearing = WALL_LEFTMOST; bearing > WALL_RIGHTMOST; bearing -= Surroundings.WIDTH) {
            if (around.range(Surroundings.sector(bearing)) <= reach) {
                return bearing;
            }
        }
        return FAR_LEFT;
    }

    private void keepCount(Pose2d odomFromBase) {
        if (odomFromLast != null) {
            turned += Angles.difference(odomFromLast.theta(), odomFromBase.theta());
            searched += odomFromLast.distanceTo(odomFromBase);
        }
        odomFromLast = odomFromBase;
    }
}
