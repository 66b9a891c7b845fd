package rsal.scenario;

import rsal.data.Point2d;

/// A part of the floor that has a name, for conditions and metrics.
public record Place(String name, Area area) {
    /// Where it is, in the frame `map`.
    public sealed interface Area {
        /// Whether a point lies in it, or no farther out than that.
        ///
        /// @param beyond its border [m]
        boolean holds(Point2d mapFromPoint, double beyond);
    }

    /// @param radius [m]
    public record Disc(Point2d mapFromMiddle, double radius) implements Area {
        @Override
        public boolean holds(Point2d mapFromPoint, double beyond) {
            return mapFromMiddle.distanceTo(mapFromPoint) <= radius + beyond;
        }
    }

    /// @param least its lower left corner
    /// @param greatest its upper right corner
    public record Rectangle(Point2d least, Point2d greatest) implements Area {
        @Override
        public boolean holds(Point2d mapFromPoint, double beyond) {
            return mapFromPoint.x() >= least.x() - beyond
                    && mapFromPoint.y() >= least.y() - beyond
                    && mapFromPoint.x() <= greatest.x() + beyond
                    && mapFromPoint.y() <= greatest.y() + beyond;
        }
    }
}
