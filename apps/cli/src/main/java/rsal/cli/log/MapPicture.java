package rsal.cli.log;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import javax.imageio.ImageIO;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.navigation.slam.Relation;
import rsal.navigation.slam.Slam;

/// A map with the ways on which it was made (blue) and where places were known again (red).
final class MapPicture {
    private static final int LONGEST = 2000; // side [px]
    private static final Color PATH = new Color(0x1f, 0x5f, 0xd0);
    private static final Color LOOP = new Color(0xd0, 0x30, 0x30, 0x90);
    private static final int[] SHADES = {0xffffff, 0x202020, 0xc8ccd2}; // free, occupied, unknown

    private MapPicture() {}

    static byte[] png(OccupancyGrid grid, Slam slam) throws IOException {
        double scale = Math.min(1, (double) LONGEST / Math.max(grid.width(), grid.height()));
        int width = Math.max(1, (int) (grid.width() * scale));
        int height = Math.max(1, (int) (grid.height() * scale));
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, height - 1 - y, shade(grid, x / scale, y / scale, 1 / scale));
            }
        }
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        List<Pose2d> poses = slam.poses();
        for (Relation.Source source : List.of(Relation.Source.LOOP, Relation.Source.ODOMETRY)) {
            graphics.setColor(source == Relation.Source.LOOP ? LOOP : PATH);
            for (Relation relation : slam.relations()) {
                if (relation.source() == source) {
                    Pose2d from = poses.get(relation.from());
                    Pose2d to = poses.get(relation.to());
                    graphics.draw(new Line2D.Double(
                            (from.x() - grid.originX()) / grid.resolution() * scale,
                            height - (from.y() - grid.originY()) / grid.resolution() * scale,
                            (to.x() - grid.originX()) / grid.resolution() * scale,
                            height - (to.y() - grid.originY()) / grid.resolution() * scale));
                }
            }
        }
        graphics.dispose();
        var bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }

    /// Of the cells that a pixel shows.
    private static int shade(OccupancyGrid grid, double left, double bottom, double size) {
        byte darkest =
                grid.darkest((int) left, (int) bottom, (int) Math.ceil(Math.max(left + size, (int) left + 1)), (int)
                        Math.ceil(Math.max(bottom + size, (int) bottom + 1)));
        return switch (darkest) {
            case OccupancyGrid.FREE -> SHADES[0];
            case OccupancyGrid.OCCUPIED -> SHADES[1];
            default -> SHADES[2];
        };
    }
}
