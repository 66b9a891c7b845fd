package rsal.sim.world;

import java.util.List;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.Shift;
import rsal.scene.Surface;

/// Feels what is in the way of a robot in a box of 1 cm depth outside of a straight line on it.
public final class BumperGeometry {
    private static final double DEPTH = 0.01; // [m]

    private final Figure figure;

    /// @param baseFromLine its middle, the x axis pointing outwards
    /// @param length along the y axis [m]
    /// @param height above the base [m]
    public BumperGeometry(Pose2d baseFromLine, double length, double height) {
        List<Point2d> corners = Footprint.box(DEPTH, length, new Point2d(DEPTH / 2, 0)).corners().stream()
                .map(baseFromLine::transform)
                .toList();
        var box = new ConvexOutline(corners);
        figure = new Figure(
                List.of(new CollisionShape.Prism(box, height - DEPTH / 2, height + DEPTH / 2, Surface.PLAIN)));
    }

    /// Whether it feels something where all are now.
    ///
    /// @param shift by which it has been carried along
    public boolean isPressed(World world, Body robot, Shift shift) {
        figure.placeAt(robot.figure.shifted(shift));
        return world.isBlocked(figure, robot);
    }
}
