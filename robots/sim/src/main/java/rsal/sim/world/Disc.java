package rsal.sim.world;

/// A circle with all that is in it.
final class Disc extends PlacedShape {
    private final double middleX; // in the base frame
    private final double middleY;
    private final double radius;
    private double x;
    private double y;

    Disc(CollisionShape.Cylinder cylinder) {
        super(cylinder);
        middleX = cylinder.center().x();
        middleY = cylinder.center().y();
        radius = cylinder.radius();
        place(0, 0, 1, 0);
    }

    @Override
    void place(double baseX, double baseY, double cos, double sin) {
        x = baseX + cos * middleX - sin * middleY;
        y = baseY + sin * middleX + cos * middleY;
    }

    @Override
    double radius() {
        return radius;
    }

    @Override
    double x() {
        return x;
    }

    @Override
    double y() {
        return y;
    }

    @Override
    double minX() {
        return x - radius;
    }

    @Override
    double minY() {
        return y - radius;
    }

    @Override
    double maxX() {
        return x + radius;
    }

    @Override
    double maxY() {
        return y + radius;
    }

    /// Exactly.
    double separation(Disc other) {
        double dx = other.x - x;
        double dy = other.y - y;
        return Math.sqrt(dx * dx + dy * dy) - radius - other.radius;
    }

    /// Exactly.
    double separation(Polygon other) {
        return other.distance(x, y) - radius;
    }

    @Override
    double separation(double left, double bottom, double right, double top) {
        double outsideX = Math.max(left - x, x - right);
        double outsideY = Math.max(bottom - y, y - top);
        if (outsideX > 0 && outsideY > 0) {
            return Math.sqrt(outsideX * outsideX + outsideY * outsideY) - radius;
        }
        return Math.max(outsideX, outsideY) - radius;
    }

    @Override
    double least(double nx, double ny) {
        return nx * x + ny * y - radius;
    }

    @Override
    double ray(double fromX, double fromY, double dx, double dy) {
        double toX = x - fromX;
        double toY = y - fromY;
        double outside = toX * toX + toY * toY - radius * radius;
        if (outside <= 0) {
            return 0;
        }
        double along = toX * dx + toY * dy; // to where the ray is nearest to the middle
        double square = along * along - outside;
        return along < 0 || square < 0 ? Double.POSITIVE_INFINITY : along - Math.sqrt(square);
    }

    @Override
    double rayOut(double fromX, double fromY, double dx, double dy) {
        double toX = x - fromX;
        double toY = y - fromY;
        double along = toX * dx + toY * dy;
        return along + Math.sqrt(Math.max(0, along * along - (toX * toX + toY * toY - radius * radius)));
    }
}
