package rsal.stage;

import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.image.Bitmap;

/// What is solid of a model, in its frame: axes through its pose, z from its underside [m]. Its origin is
/// accounted for. To get heights in the world, add its placement's z.
///
/// @param raster solid cells of an image that is too large to be told in prisms
public record SolidBody(List<Prism> prisms, Optional<Raster> raster) {
    public static final SolidBody NONE = new SolidBody(List.of(), Optional.empty());

    public SolidBody {
        prisms = List.copyOf(prisms);
    }

    public boolean isEmpty() {
        return prisms.isEmpty() && raster.isEmpty();
    }

    /// A polygon from one height to another.
    ///
    /// @param outline counter-clockwise, not necessarily convex; two corners make a wall without thickness
    /// @param heights of its underside and top above the model's z [m]
    /// @param color when it is not the model's
    public record Prism(List<Point2d> outline, ValueRange heights, Optional<StageColor> color) {
        public Prism {
            outline = List.copyOf(outline);
        }
    }

    /// Cells from one height to another.
    ///
    /// @param bitmap trimmed to what is solid, as in Stage
    /// @param modelFromCorner where the lower left corner is, columns along its x
    /// @param cellLength along a row [m]
    /// @param cellWidth along a column [m]; about the same for maps whose size fits their image
    /// @param heights of underside and top above the model's z [m]
    public record Raster(
            Bitmap bitmap, Pose2d modelFromCorner, double cellLength, double cellWidth, ValueRange heights) {}
}
