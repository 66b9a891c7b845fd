package rsal.scenario.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.SolidRaster;

/// Where level rays end in a world before its first step: at walls, things and robots that are seen by range sensors
/// at their height.
final class WorldSight {
    private final List<SolidRaster> walls;
    private final List<Obstacle> obstacles = new ArrayList<>();

    WorldSight(List<SolidRaster> walls, List<Entity> bodies) {
        this.walls =
                walls.stream().filter(wall -> wall.surface().seenByRangers()).toList();
        for (Entity body : bodies) {
            for (Block block : body.blocks()) {
                if (block.surface().seenByRangers()) {
                    obstacles.add(Obstacle.of(body, block));
                }
            }
        }
    }

    /// Rays from one eye, side by side.
    ///
    /// @param mapFromEye the first is `first` counter-clockwise from its x axis [rad]
    /// @param apart from one to the next [rad]
    /// @param reach how far they go at most [m]
    record Fan(Pose2d mapFromEye, double height, double first, double apart, int rays, double reach) {
        double direction(int ray) {
            return mapFromEye.theta() + first + ray * apart;
        }
    }

    /// How far each ray of a fan gets [m].
    ///
    /// @param owner name of the body that they pass through
    double[] ranges(Fan fan, String owner) {
        var ranges = new double[fan.rays];
        Arrays.fill(ranges, fan.reach);
        for (SolidRaster wall : walls) {
            if (fan.height >= wall.lowest() && fan.height < wall.highest()) {
                for (int ray = 0; ray < fan.rays; ray++) {
                    ranges[ray] = Math.min(ranges[ray], range(wall, fan.mapFromEye, fan.direction(ray), ranges[ray]));
                }
            }
        }
        for (Obstacle obstacle : obstacles) {
            if (fan.height >= obstacle.bottom && fan.height < obstacle.top && !obstacle.owner.equals(owner)) {
                obstacle.end(fan, ranges);
            }
        }
        return ranges;
    }

    /// Walks from cell to cell (Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987).
    private static double range(SolidRaster wall, Pose2d eye, double direction, double limit) {
        double x = (eye.x() - wall.left()) / wall.cellX();
        double y = (eye.y() - wall.bottom()) / wall.cellY();
        double dx = Math.cos(direction) / wall.cellX(); // cells per m
        double dy = Math.sin(direction) / wall.cellY();
        double range = Math.max(0, Math.max(entry(x, dx, wall.width()), entry(y, dy, wall.height())));
        int column = cell(x + range * dx, wall.width());
        int row = cell(y + range * dy, wall.height());
        while (range < limit && column >= 0 && column < wall.width() && row >= 0 && row < wall.height()) {
            if (wall.solid().get(row * wall.width() + column)) {
                return range;
            }
            double nextX = border(x, dx, column);
            double nextY = border(y, dy, row);
            range = Math.max(range, Math.min(nextX, nextY));
            if (nextX < nextY) {
                column += dx > 0 ? 1 : -1;
            } else {
                row += dy > 0 ? 1 : -1;
            }
        }
        return limit;
    }

    /// How far the side is at which a ray comes in; +∞ when it never does [m].
    private static double entry(double from, double direction, int cells) {
        if (from >= 0 && from <= cells) {
            return 0;
        }
        double way = ((from < 0 ? 0 : cells) - from) / direction;
        return way >= 0 ? way : Double.POSITIVE_INFINITY;
    }

    /// The cell at a place; those at the border are within.
    private static int cell(double at, int cells) {
        double near = Math.clamp(at, -1e-9, cells + 1e-9) == at ? Math.clamp(at, 0, Math.nextDown((double) cells)) : at;
        return (int) Math.floor(near);
    }

    /// How far it is to where a ray leaves a cell [m].
    private static double border(double from, double direction, int cell) {
        return direction == 0 ? Double.POSITIVE_INFINITY : ((direction > 0 ? cell + 1 : cell) - from) / direction;
    }

    /// A piece of a body, where it is.
    ///
    /// @param corners none for a disc
    /// @param radius of the circle around it [m]
    private record Obstacle(
            String owner, double bottom, double top, Point2d center, double radius, List<Point2d> corners) {
        static Obstacle of(Entity body, Block block) {
            double bottom = body.height() + block.prism().bottom();
            double top = body.height() + block.prism().top();
            return switch (block.prism().shape()) {
                case Shape.Disc disc ->
                    new Obstacle(
                            body.name(),
                            bottom,
                            top,
                            body.mapFromEntity().transform(disc.center()),
                            disc.radius(),
                            List.of());
                case Shape.Polygon polygon -> {
                    List<Point2d> corners = polygon.corners().stream()
                            .map(body.mapFromEntity()::transform)
                            .toList();
                    var center = new Point2d(
                            corners.stream().mapToDouble(Point2d::x).average().orElse(0),
                            corners.stream().mapToDouble(Point2d::y).average().orElse(0));
                    double radius = corners.stream()
                            .mapToDouble(center::distanceTo)
                            .max()
                            .orElse(0);
                    yield new Obstacle(body.name(), bottom, top, center, radius, corners);
                }
            };
        }

        /// Ends those rays of a fan that meet it.
        void end(Fan fan, double[] ranges) {
            Point2d eye = new Point2d(fan.mapFromEye.x(), fan.mapFromEye.y());
            double distance = center.distanceTo(eye);
            if (distance - radius > fan.reach) {
                return;
            }
            double extent = fan.apart * (fan.rays - 1);
            double half = distance > radius ? Math.asin(radius / distance) : Math.PI;
            double bearing = Math.atan2(center.y() - eye.y(), center.x() - eye.x());
            double off = Math.IEEEremainder(bearing - fan.direction(0) - extent / 2, 2 * Math.PI) + extent / 2;
            boolean all = fan.apart == 0 || extent + 2 * half > 2 * Math.PI;
            int from = all ? 0 : Math.max(0, (int) Math.floor((off - half) / fan.apart));
            int to = all ? fan.rays - 1 : Math.min(fan.rays - 1, (int) Math.ceil((off + half) / fan.apart));
            for (int ray = from; ray <= to; ray++) {
                double dx = Math.cos(fan.direction(ray));
                double dy = Math.sin(fan.direction(ray));
                ranges[ray] = Math.min(ranges[ray], corners.isEmpty() ? toDisc(eye, dx, dy) : toEdge(eye, dx, dy));
            }
        }

        private double toDisc(Point2d eye, double dx, double dy) {
            double along = (center.x() - eye.x()) * dx + (center.y() - eye.y()) * dy;
            double aside = (center.x() - eye.x()) * dy - (center.y() - eye.y()) * dx;
            double square = radius * radius - aside * aside;
            if (square < 0 || along + Math.sqrt(square) < 0) {
                return Double.POSITIVE_INFINITY;
            }
            return Math.max(0, along - Math.sqrt(square));
        }

        /// 0 from within: then as many edges are crossed one way as the other, and one more.
        private double toEdge(Point2d eye, double dx, double dy) {
            double nearest = Double.POSITIVE_INFINITY;
            int crossed = 0;
            for (int i = 0; i < corners.size(); i++) {
                Point2d a = corners.get(i);
                Point2d b = corners.get((i + 1) % corners.size());
                double sideA = (a.x() - eye.x()) * dy - (a.y() - eye.y()) * dx;
                double sideB = (b.x() - eye.x()) * dy - (b.y() - eye.y()) * dx;
                if (sideA > 0 == sideB > 0) {
                    continue;
                }
                double share = sideA / (sideA - sideB);
                double along = (a.x() + share * (b.x() - a.x()) - eye.x()) * dx
                        + (a.y() + share * (b.y() - a.y()) - eye.y()) * dy;
                if (along >= 0) {
                    nearest = Math.min(nearest, along);
                    crossed++;
                }
            }
            return crossed % 2 == 1 ? 0 : nearest;
        }
    }
}
