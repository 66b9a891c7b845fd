package rsal.sim.world;

/// A convex polygon, placed somewhere. Flat arrays, as all rays and collision checks look at them.
final class Polygon extends PlacedShape {
    private final ConvexOutline outline;
    private final int count;
    private final double radius;

    private double x;
    private double y;
    private final double[] cornerX;
    private final double[] cornerY;
    private final double[] normalX;
    private final double[] normalY;
    private final double[] offset;
    private double minX;
    private double minY;
    private double maxX;
    private double maxY;

    Polygon(CollisionShape.Prism prism) {
        super(prism);
        outline = prism.outline();
        count = outline.count;
        radius = outline.radius;
        cornerX = new double[count];
        cornerY = new double[count];
        normalX = new double[count];
        normalY = new double[count];
        offset = new double[count];
        place(0, 0, 1, 0);
    }

    @Override
    void place(double baseX, double baseY, double cos, double sin) {
        x = baseX + cos * outline.middleX - sin * outline.middleY;
        y = baseY + sin * outline.middleX + cos * outline.middleY;
        minX = Double.POSITIVE_INFINITY;
        minY = Double.POSITIVE_INFINITY;
        maxX = Double.NEGATIVE_INFINITY;
        maxY = Double.NEGATIVE_INFINITY;
        ConvexOutline body = outline;
        for (int i = 0; i < count; i++) {
            cornerX[i] = baseX + cos * body.x[i] - sin * body.y[i];
            cornerY[i] = baseY + sin * body.x[i] + cos * body.y[i];
            normalX[i] = cos * body.normalX[i] - sin * body.normalY[i];
            normalY[i] = sin * body.normalX[i] + cos * body.normalY[i];
            offset[i] = body.offset[i] + normalX[i] * baseX + normalY[i] * baseY;
            minX = Math.min(minX, cornerX[i]);
            minY = Math.min(minY, cornerY[i]);
            maxX = Math.max(maxX, cornerX[i]);
            maxY = Math.max(maxY, cornerY[i]);
        }
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
        return minX;
    }

    @Override
    double minY() {
        return minY;
    }

    @Override
    double maxX() {
        return maxX;
    }

    @Override
    double maxY() {
        return maxY;
    }

    /// The largest gap along the normal of any edge (separating axes): exact from a face, less from a corner.
    double separation(Polygon other) {
        return Math.max(gapTo(other), other.gapTo(this));
    }

    private double gapTo(Polygon other) {
        double gap = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int j = 0; j < other.count; j++) {
                nearest = Math.min(nearest, normalX[i] * other.cornerX[j] + normalY[i] * other.cornerY[j]);
            }
            gap = Math.max(gap, nearest - offset[i]);
        }
        return gap;
    }

    @Override
    double separation(double left, double bottom, double right, double top) {
        double gap = Math.max(Math.max(left - maxX, minX - right), Math.max(bottom - maxY, minY - top));
        for (int i = 0; i < count; i++) {
            double nearest =
                    normalX[i] * (normalX[i] > 0 ? left : right) + normalY[i] * (normalY[i] > 0 ? bottom : top);
            gap = Math.max(gap, nearest - offset[i]);
        }
        return gap;
    }

    @Override
    double least(double nx, double ny) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, nx * cornerX[i] + ny * cornerY[i]);
        }
        return least;
    }

    /// How far a point is from it [m], exactly; 0 or less inside.
    double distance(double pointX, double pointY) {
        double outside = Double.NEGATIVE_INFINITY;
        double square = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            outside = Math.max(outside, normalX[i] * pointX + normalY[i] * pointY - offset[i]);
            int next = i + 1 < count ? i + 1 : 0;
            double edgeX = cornerX[next] - cornerX[i];
            double edgeY = cornerY[next] - cornerY[i];
            double toX = pointX - cornerX[i];
            double toY = pointY - cornerY[i];
            double along = (toX * edgeX + toY * edgeY) / (edgeX * edgeX + edgeY * edgeY);
            double part = Math.clamp(along, 0.0, 1.0);
            double dx = toX - part * edgeX;
            double dy = toY - part * edgeY;
            square = Math.min(square, dx * dx + dy * dy);
        }
        return outside <= 0 ? outside : Math.sqrt(square);
    }

    /// Clips the ray by one half plane after the other (Cyrus and Beck 1978).
    @Override
    double ray(double fromX, double fromY, double dx, double dy) {
        double enters = 0;
        double leaves = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double outside = normalX[i] * fromX + normalY[i] * fromY - offset[i];
            double along = normalX[i] * dx + normalY[i] * dy;
            if (along < 0) {
                enters = Math.max(enters, -outside / along);
            } else if (along > 0) {
                leaves = Math.min(leaves, -outside / along);
            } else if (outside > 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return enters <= leaves ? enters : Double.POSITIVE_INFINITY;
    }

    @Override
    double rayOut(double fromX, double fromY, double dx, double dy) {
        double leaves = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double along = normalX[i] * dx + normalY[i] * dy;
            if (along > 0) {
                leaves = Math.min(leaves, (offset[i] - normalX[i] * fromX - normalY[i] * fromY) / along);
            }
        }
        return leaves;
    }
}
