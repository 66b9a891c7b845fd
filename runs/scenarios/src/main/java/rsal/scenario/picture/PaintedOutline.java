package rsal.scenario.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// How pieces of robots and things look from above, in pictures.
public final class PaintedOutline {
    private PaintedOutline() {}

    /// In the map frame [m].
    public static Shape of(rsal.data.Shape shape, Pose2d mapFromBody) {
        return switch (shape) {
            case rsal.data.Shape.Disc disc -> {
                Point2d center = mapFromBody.transform(disc.center());
                yield new Ellipse2D.Double(
                        center.x() - disc.radius(), center.y() - disc.radius(), 2 * disc.radius(), 2 * disc.radius());
            }
            case rsal.data.Shape.Polygon polygon -> {
                var path = new Path2D.Double();
                List<Point2d> corners =
                        polygon.corners().stream().map(mapFromBody::transform).toList();
                path.moveTo(corners.getFirst().x(), corners.getFirst().y());
                corners.forEach(corner -> path.lineTo(corner.x(), corner.y()));
                path.closePath();
                yield path;
            }
        };
    }

    /// Fills an outline, and draws its edge darker, with the stroke that is set.
    ///
    /// @param outline in pixels
    public static void paint(Graphics2D graphics, Shape outline, Color color) {
        graphics.setColor(color);
        graphics.fill(outline);
        graphics.setColor(color.darker());
        graphics.draw(outline);
    }
}
