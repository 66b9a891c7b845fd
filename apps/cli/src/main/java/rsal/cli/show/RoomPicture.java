package rsal.cli.show;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.rooms.MapRegion;
import rsal.navigation.rooms.RegionKind;
import rsal.navigation.rooms.RoomGate;
import rsal.navigation.rooms.RoomMap;

/// A map whose rooms have colors, neighbors different ones, with corridors in gray, gates as red lines, and
/// the number and area of each region.
final class RoomPicture {
    private static final int LONGEST = 2000; // side [px]
    private static final int MOST_PER_CELL = 8; // [px]
    private static final Color WALL = new Color(0x2b, 0x2f, 0x36);
    private static final Color UNKNOWN = new Color(0xc9, 0xcd, 0xd3);
    private static final Color HOLE = new Color(0xf4, 0xf4, 0xf2);
    private static final Color CORRIDOR = new Color(0xe6, 0xe4, 0xdd);
    private static final Color GATE = new Color(0xc2, 0x3b, 0x22);
    private static final Color PLACE = new Color(0x14, 0x4f, 0xb8);
    private static final Color TEXT = new Color(0x2b, 0x2f, 0x36);
    private static final int[] ROOMS = {
        0xa9cce3, 0xf5cba7, 0xabdbb8, 0xd7bde2, 0xf9e79f, 0xf2b8b5, 0xa3e0dc, 0xc5d99b, 0xe8c6d8, 0xbfc9e8
    };

    private final RoomMap rooms;
    private final OccupancyGrid map;
    private final double scale; // [px per cell]
    private final BufferedImage image;
    private final Color[] colors;

    private RoomPicture(RoomMap rooms, List<Point2d> places) {
        this.rooms = rooms;
        this.map = rooms.map();
        this.scale = Math.min(MOST_PER_CELL, (double) LONGEST / Math.max(map.width(), map.height()));
        this.image = new BufferedImage(
                Math.max(1, (int) (map.width() * scale)),
                Math.max(1, (int) (map.height() * scale)),
                BufferedImage.TYPE_INT_RGB);
        this.colors = colors(rooms);
        paintCells();
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        rooms.gates().forEach(gate -> draw(gate, graphics));
        rooms.regions().forEach(region -> write(region, graphics));
        places.forEach(place -> draw(place, graphics));
        graphics.dispose();
    }

    /// @param places that are marked, on the map
    /// @return a PNG
    static byte[] png(RoomMap rooms, List<Point2d> places) throws IOException {
        var bytes = new ByteArrayOutputStream();
        ImageIO.write(new RoomPicture(rooms, places).image, "png", bytes);
        return bytes.toByteArray();
    }

    /// Each room's is the first that no neighbor has, from another start each.
    private static Color[] colors(RoomMap rooms) {
        var chosen = new int[rooms.regions().size()];
        var colors = new Color[chosen.length];
        for (MapRegion region : rooms.regions()) {
            int number = region.number();
            var taken = new boolean[ROOMS.length];
            rooms.neighbors(number).stream()
                    .filter(neighbor -> neighbor < number)
                    .forEach(neighbor -> taken[chosen[neighbor]] = true);
            int color = number % ROOMS.length;
            for (int tries = 0; taken[color] && tries < ROOMS.length; tries++) {
                color = (color + 1) % ROOMS.length;
            }
            chosen[number] = color;
            colors[number] = region.kind() == RegionKind.CORRIDOR ? CORRIDOR : new Color(ROOMS[color]);
        }
        return colors;
    }

    private void paintCells() {
        for (int y = 0; y < image.getHeight(); y++) {
            int bottom = (int) ((image.getHeight() - 1 - y) / scale);
            int top = Math.max(bottom + 1, (int) Math.ceil((image.getHeight() - y) / scale));
            for (int x = 0; x < image.getWidth(); x++) {
                int left = (int) (x / scale);
                int right = Math.max(left + 1, (int) Math.ceil((x + 1) / scale));
                Color color = switch (map.darkest(left, bottom, right, top)) {
                    case OccupancyGrid.OCCUPIED -> WALL;
                    case OccupancyGrid.FREE -> floor(left, bottom);
                    default -> UNKNOWN;
                };
                image.setRGB(x, y, color.getRGB());
            }
        }
    }

    private Color floor(int column, int row) {
        int region = rooms.regionOf(row * map.width() + column);
        return region == RoomMap.NONE ? HOLE : colors[region];
    }

    private double x(Point2d place) {
        return (place.x() - map.originX()) / map.resolution() * scale;
    }

    private double y(Point2d place) {
        return image.getHeight() - (place.y() - map.originY()) / map.resolution() * scale;
    }

    private void draw(RoomGate gate, Graphics2D graphics) {
        graphics.setColor(GATE);
        graphics.setStroke(
                new BasicStroke((float) Math.max(2.5, scale), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.draw(new Line2D.Double(x(gate.from()), y(gate.from()), x(gate.to()), y(gate.to())));
    }

    /// A disc as large as a robot of 0.6 m, or large enough to be seen.
    private void draw(Point2d place, Graphics2D graphics) {
        double radius = Math.max(7, 0.3 / map.resolution() * scale);
        var disc = new Ellipse2D.Double(x(place) - radius, y(place) - radius, 2 * radius, 2 * radius);
        graphics.setColor(PLACE);
        graphics.fill(disc);
        graphics.setColor(Color.WHITE);
        graphics.setStroke(new BasicStroke(2));
        graphics.draw(disc);
    }

    /// The number, and below it the area, as large as the region lets.
    private void write(MapRegion region, Graphics2D graphics) {
        double half = region.clearance() / map.resolution() * scale; // [px]
        int size = (int) Math.min(24, half * 0.55);
        if (size < 7) {
            return;
        }
        graphics.setColor(TEXT);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.BOLD, size));
        center(String.valueOf(region.number()), region.middle(), -size * 0.05, graphics);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, Math.max(7, (int) (size * 0.7))));
        center(String.format(Locale.ROOT, "%.0f m²", region.area()), region.middle(), size * 0.85, graphics);
    }

    private void center(String text, Point2d place, double below, Graphics2D graphics) {
        FontMetrics metrics = graphics.getFontMetrics();
        graphics.drawString(text, (float) (x(place) - metrics.stringWidth(text) / 2.0), (float) (y(place) + below));
    }
}
