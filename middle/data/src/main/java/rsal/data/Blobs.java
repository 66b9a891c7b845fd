package rsal.data;

import java.util.List;
import java.util.Optional;

/// Patches of color in one image (Player `blobfinder`; ROS has no message for them). Columns count from the
/// left, rows from the top; neighboring columns of an image differ by the same angle, as in Stage.
///
/// @param baseFromCamera where the camera is mounted, looking along its x axis
/// @param width of the image [px]
/// @param height of the image [px]
/// @param fieldOfView from the left edge of the image to its right [rad]
/// @param blobs from left to right, by their first columns
public record Blobs(Pose2d baseFromCamera, int width, int height, double fieldOfView, List<Blob> blobs) {
    public Blobs {
        blobs = List.copyOf(blobs);
    }

    /// A patch of one color.
    ///
    /// @param left first column [px]
    /// @param top first row [px]
    /// @param right one past the last column [px]
    /// @param bottom one past the last row [px]
    /// @param x of its middle [px]; the first column reaches from 0 to 1
    /// @param y of its middle [px]
    /// @param area number of its pixels
    /// @param range how far it is, as seen from above [m]; NaN when the camera can't tell
    public record Blob(
            Rgb color, int left, int top, int right, int bottom, double x, double y, int area, double range) {}

    /// Direction of a blob's middle in the camera's frame [rad]: 0 is ahead, positive to the left.
    public double bearing(Blob blob) {
        return bearing(blob.x());
    }

    /// Direction of a place in the image in the camera's frame [rad].
    ///
    /// @param x [px]
    public double bearing(double x) {
        return fieldOfView * (0.5 - x / width);
    }

    /// Where in the image a direction is [px]; outside of 0 … width when the camera does not see it.
    ///
    /// @param bearing in the camera's frame [rad]
    public double column(double bearing) {
        return width * (0.5 - bearing / fieldOfView);
    }

    /// Where a blob is in the robot's base frame; empty when its range is not known.
    public Optional<Point2d> baseFromBlob(Blob blob) {
        return Double.isFinite(blob.range())
                ? Optional.of(baseFromCamera.transform(
                        Pose2d.polar(blob.range(), bearing(blob)).position()))
                : Optional.empty();
    }
}
