package rsal.stage;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.image.Bitmap;
import rsal.stage.SolidBody.Prism;
import rsal.stage.SolidBody.Raster;

/// Makes bodies of blocks, bitmaps, boxes and boundaries, scaled to a model's size and moved to its origin.
final class BodyBuilder {
    private static final double BOUNDARY = 0.01; // how thick its walls are [m]
    private static final int MOST_RECTANGLES = 500; // that a bitmap is told in
    private static final int MOST_PIXELS_IN_RECTANGLES = 10_000;

    private final Size size;
    private final Placement origin;
    private final List<Prism> prisms = new ArrayList<>();
    private Optional<Raster> raster = Optional.empty();

    BodyBuilder(Size size, Placement origin) {
        this.size = size;
        this.origin = origin;
    }

    SolidBody build() {
        return new SolidBody(prisms, raster);
    }

    /// A block as it is written.
    ///
    /// @param corners in units of its own
    /// @param heights the same
    record Block(List<Point2d> corners, ValueRange heights, Optional<StageColor> color) {}

    /// All of the size.
    void box() {
        box(-size.x() / 2, size.x() / 2, -size.y() / 2, size.y() / 2, size.z());
    }

    /// A box in the body's frame, standing on its underside.
    void box(double left, double right, double bottom, double top, double height) {
        if (right > left && top > bottom) {
            prisms.add(prism(rectangle(left, right, bottom, top), new ValueRange(0, height), Optional.empty()));
        }
    }

    /// Four walls along the inside of the size.
    void boundary() {
        double x = size.x() / 2;
        double y = size.y() / 2;
        double thick = Math.min(BOUNDARY, Math.min(x, y));
        box(-x, x, y - thick, y, size.z());
        box(-x, x, -y, thick - y, size.z());
        box(-x, thick - x, thick - y, y - thick, size.z());
        box(x - thick, x, thick - y, y - thick, size.z());
    }

    /// Blocks, which together fill the size in x and y; z is stretched only, so that what is above the ground
    /// stays so.
    void blocks(List<Block> blocks) {
        ValueRange x = extent(blocks.stream().flatMap(b -> b.corners().stream()).mapToDouble(Point2d::x));
        ValueRange y = extent(blocks.stream().flatMap(b -> b.corners().stream()).mapToDouble(Point2d::y));
        ValueRange z = extent(
                blocks.stream().mapToDouble(b -> b.heights().min()),
                blocks.stream().mapToDouble(b -> b.heights().max()));
        double scaleX = scale(size.x(), x);
        double scaleY = scale(size.y(), y);
        double scaleZ = scale(size.z(), z);
        double middleX = (x.min() + x.max()) / 2;
        double middleY = (y.min() + y.max()) / 2;
        for (Block block : blocks) {
            List<Point2d> corners = block.corners().stream()
                    .map(c -> new Point2d((c.x() - middleX) * scaleX, (c.y() - middleY) * scaleY))
                    .toList();
            var heights = new ValueRange(
                    block.heights().min() * scaleZ, block.heights().max() * scaleZ);
            prisms.add(prism(corners, heights, block.color()));
        }
    }

    /// What is solid of an image, trimmed and stretched to the size.
    void bitmap(Bitmap whole) {
        Bitmap bitmap = whole.trimmed();
        if (bitmap.solid().isEmpty()) {
            return;
        }
        double length = size.x() / bitmap.width();
        double width = size.y() / bitmap.height();
        List<int[]> rectangles = (long) bitmap.width() * bitmap.height() <= MOST_PIXELS_IN_RECTANGLES
                ? bitmap.rectangles(MOST_RECTANGLES)
                : List.of();
        if (rectangles.isEmpty() || rectangles.size() > MOST_RECTANGLES) {
            Pose2d bodyFromCorner = new Pose2d(-size.x() / 2, -size.y() / 2, 0);
            raster = Optional.of(new Raster(
                    bitmap,
                    origin.pose().compose(bodyFromCorner),
                    length,
                    width,
                    new ValueRange(origin.z(), origin.z() + size.z())));
            return;
        }
        for (int[] r : rectangles) {
            box(
                    r[0] * length - size.x() / 2,
                    r[1] * length - size.x() / 2,
                    r[2] * width - size.y() / 2,
                    r[3] * width - size.y() / 2,
                    size.z());
        }
    }

    private Prism prism(List<Point2d> corners, ValueRange heights, Optional<StageColor> color) {
        Pose2d modelFromBody = origin.pose();
        List<Point2d> placed = corners.stream().map(modelFromBody::transform).toList();
        return new Prism(
                area(placed) < 0 ? placed.reversed() : placed,
                new ValueRange(origin.z() + heights.min(), origin.z() + heights.max()),
                color);
    }

    private static List<Point2d> rectangle(double left, double right, double bottom, double top) {
        return List.of(
                new Point2d(left, bottom), new Point2d(right, bottom), new Point2d(right, top), new Point2d(left, top));
    }

    /// Twice the area, positive when counter-clockwise.
    private static double area(List<Point2d> corners) {
        double area = 0;
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            area += a.x() * b.y() - b.x() * a.y();
        }
        return area;
    }

    /// What is flat stays so.
    private static double scale(double side, ValueRange extent) {
        double length = extent.max() - extent.min();
        return length > 0 ? side / length : 1;
    }

    private static ValueRange extent(DoubleStream values) {
        var statistics = values.summaryStatistics();
        return new ValueRange(statistics.getMin(), statistics.getMax());
    }

    private static ValueRange extent(DoubleStream least, DoubleStream greatest) {
        return new ValueRange(least.min().orElse(0), greatest.max().orElse(0));
    }
}
