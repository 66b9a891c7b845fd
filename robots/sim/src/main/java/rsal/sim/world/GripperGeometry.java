package rsal.sim.world;

import java.util.Optional;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.robot.Shift;

/// The space between two paddles of a robot, and what of grippable things is in it where all are now. In the frame of
/// the gripper, paddles reach along x, one on each side at the same distance from y = 0.
public final class GripperGeometry {
    private final World world;
    private final Body robot;
    private final Pose2d baseFromGripper;
    private final double root; // where paddles begin [m]
    private final double length; // of paddles [m]
    private final double opening; // between them when they are open [m]
    private final double bottom; // above the base [m]
    private final double height; // of paddles [m]

    // of the gripper in the map frame, and of the paddles above ground
    private double x;
    private double y;
    private double cos;
    private double sin;
    private double low;
    private double high;

    public GripperGeometry(
            World world,
            Body robot,
            Pose2d baseFromGripper,
            double root,
            double length,
            double opening,
            double bottom,
            double height) {
        this.world = world;
        this.robot = robot;
        this.baseFromGripper = baseFromGripper;
        this.root = root;
        this.length = length;
        this.opening = opening;
        this.bottom = bottom;
        this.height = height;
    }

    /// Something between the paddles.
    ///
    /// @param width across [m]
    /// @param middle where across its middle is [m]
    public record Grip(Body thing, double width, double middle) {}

    /// Goes where the robot is.
    ///
    /// @param shift by which the gripper has been carried along
    /// @param raised above where the paddles are when the lift is down [m]
    public void follow(Shift shift, double raised) {
        Pose2d mapFromGripper = robot.pose().compose(shift.moved(baseFromGripper));
        x = mapFromGripper.x();
        y = mapFromGripper.y();
        cos = StrictMath.cos(mapFromGripper.theta());
        sin = StrictMath.sin(mapFromGripper.theta());
        low = robot.height() + bottom + shift.rise() + raised;
        high = low + height;
    }

    /// The widest thing between the paddles that can be gripped and fits between them when they are open.
    ///
    /// @param gap between the paddles now [m]; what is wider is not between them
    /// @param loose what is free to be taken
    public Optional<Grip> widest(double gap, Predicate<? super Body> loose) {
        Grip widest = null;
        PieceGrid.Found near = near();
        for (int i = 0; i < near.count; i++) {
            Body owner = world.owner(near.slots[i]);
            boolean known = widest != null && widest.thing == owner;
            if (!known && isIn(world.now(near.slots[i])) && owner != robot && loose.test(owner)) {
                Grip grip = grip(owner);
                boolean fits = grip.width <= gap && Math.abs(grip.middle) + grip.width / 2 <= opening / 2;
                if (fits && (widest == null || grip.width > widest.width)) {
                    widest = grip;
                }
            }
        }
        return Optional.ofNullable(widest);
    }

    /// Whether something is on a line across, from paddle to paddle.
    ///
    /// @param at where along the paddles, 0 at their root, 1 at their tips
    /// @param gap between the paddles [m]
    /// @param held what is gripped already, if anything
    public boolean isAcross(double at, double gap, @Nullable Body held) {
        return meets(root + at * length, -gap / 2, 0, 1, gap, held);
    }

    /// Whether something is on the inner face of a paddle.
    ///
    /// @param across where that is [m]; positive is left
    public boolean isAlong(double across, @Nullable Body held) {
        return meets(root, across, 1, 0, length, held);
    }

    private boolean meets(double fromX, double fromY, double dx, double dy, double distance, @Nullable Body held) {
        if (held != null && meets(held, fromX, fromY, dx, dy, distance)) {
            return true;
        }
        PieceGrid.Found near = near();
        for (int i = 0; i < near.count; i++) {
            PlacedShape piece = world.now(near.slots[i]);
            if (world.owner(near.slots[i]) != robot && meets(piece, fromX, fromY, dx, dy, distance)) {
                return true;
            }
        }
        return false;
    }

    private boolean meets(Body held, double fromX, double fromY, double dx, double dy, double distance) {
        for (PlacedShape piece : held.figure.pieces) {
            if (meets(piece, fromX, fromY, dx, dy, distance)) {
                return true;
            }
        }
        return false;
    }

    private boolean meets(PlacedShape piece, double fromX, double fromY, double dx, double dy, double distance) {
        double range = piece.ray(
                x + cos * fromX - sin * fromY, y + sin * fromX + cos * fromY, cos * dx - sin * dy, sin * dx + cos * dy);
        return piece.surface.grippable() && piece.isBetween(low, high) && range <= distance;
    }

    private PieceGrid.Found near() {
        double middle = root + length / 2;
        return world.nowNear(x + cos * middle, y + sin * middle, Math.hypot(length, opening) / 2);
    }

    private boolean isIn(PlacedShape piece) {
        double ahead = x * cos + y * sin; // of the gripper
        boolean along = piece.least(cos, sin) - ahead < root + length && -piece.least(-cos, -sin) - ahead > root;
        boolean across = leftmost(piece) > -opening / 2 && rightmost(piece) < opening / 2;
        return piece.surface.grippable() && piece.isBetween(low, high) && along && across;
    }

    private double rightmost(PlacedShape piece) {
        return piece.least(-sin, cos) - (y * cos - x * sin);
    }

    private double leftmost(PlacedShape piece) {
        return -piece.least(sin, -cos) - (y * cos - x * sin);
    }

    private Grip grip(Body body) {
        double right = Double.POSITIVE_INFINITY;
        double left = Double.NEGATIVE_INFINITY;
        for (PlacedShape piece : body.figure.pieces) {
            if (isIn(piece)) {
                right = Math.min(right, rightmost(piece));
                left = Math.max(left, leftmost(piece));
            }
        }
        return new Grip(body, left - right, (left + right) / 2);
    }
}
