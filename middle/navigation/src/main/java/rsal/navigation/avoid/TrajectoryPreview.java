package rsal.navigation.avoid;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Twist2d;

/// Where a command leads within [#SECONDS]: on its arc, or into a direction that it turns to. Kept as a few numbers, of
/// which points are made only when somebody asks.
final class TrajectoryPreview {
    private static final double SECONDS = 2;
    private static final double STANDING = 0.02; // m/s
    private static final double BEND = 0.2; // rad from one point to the next, where there are enough of them

    private Twist2d command = Twist2d.STOP;
    private boolean turns; // into a direction, else it is on its arc
    private double turn; // that is missing to the direction [rad]
    private double longest; // m

    /// It stands, or turns in place.
    void nowhere() {
        command = Twist2d.STOP;
    }

    /// It goes on as it is commanded.
    void on(Twist2d command) {
        go(false, 0, command);
    }

    /// It turns, the slower the less is missing, until it looks into a direction.
    ///
    /// @param turn that is missing now [rad]
    void into(double turn, Twist2d command) {
        go(true, turn, command);
    }

    private void go(boolean turns, double turn, Twist2d command) {
        this.turns = turns;
        this.turn = turn;
        this.command = command;
        longest = Double.POSITIVE_INFINITY;
    }

    /// It goes no farther than so far [m].
    void upTo(double longest) {
        this.longest = longest;
    }

    /// Places of the base, in its frame of now [m]; as [Controller#way] has them.
    List<Point2d> points() {
        double speed = Math.abs(command.vx());
        if (speed < STANDING || longest <= 0) {
            return List.of();
        }
        double seconds = Math.min(SECONDS, longest / speed);
        int pieces = Math.clamp((long) Math.ceil(Math.abs(turned(seconds)) / BEND), 1, Controller.PATH_POINTS - 1);
        double length = command.vx() * seconds / pieces;
        var points = new ArrayList<Point2d>(pieces + 1);
        double x = 0;
        double y = 0;
        double theta = 0;
        points.add(new Point2d(x, y));
        for (int piece = 1; piece <= pieces; piece++) {
            double bend = turned(seconds * piece / pieces) - theta;
            double chord = bend == 0 ? length : length * Math.sin(bend / 2) / (bend / 2);
            x += chord * Math.cos(theta + bend / 2);
            y += chord * Math.sin(theta + bend / 2);
            theta += bend;
            points.add(new Point2d(x, y));
        }
        return points;
    }

    /// By what angle it has turned after some time [rad].
    private double turned(double seconds) {
        double omega = command.omega();
        if (!turns) {
            return omega * seconds;
        }
        return turn * omega > 0 ? turn * -Math.expm1(-omega / turn * seconds) : 0;
    }
}
