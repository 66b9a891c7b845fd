package rsal.sim;

import java.util.ArrayList;
import org.jspecify.annotations.Nullable;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Rgb;
import rsal.device.BlobFinder;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.scene.Surface;
import rsal.sim.world.Body;
import rsal.sim.world.View;
import rsal.sim.world.View.Sight;
import rsal.sim.world.World;

/// A simulated camera that finds patches of color. Columns side by side that see the same color make a blob, as in
/// Stage. Rows are as far apart as columns, φ = field of view / width, the horizon in the middle: what reaches from
/// `low` to `high` above the camera at range r covers the rows from height / 2 − atan2(high, r) / φ down to
/// height / 2 − atan2(low, r) / φ. (Stage takes everything for 0.6 m high.)
final class SimBlobFinder extends SimEye<Blobs> implements BlobFinder {
    private final Part.BlobFinder part;
    private final View view;

    /// @param view made by [#view]
    SimBlobFinder(DeviceInfo info, Part.BlobFinder part, View view, Mount mount) {
        super(info, info.id(), part.period(), mount);
        this.part = part;
        this.view = view;
    }

    /// @param height above the base [m]
    static View view(Part.BlobFinder part, double height) {
        return new View(part.baseFromCamera(), part.width(), part.height(), part.fieldOfView(), height);
    }

    @Override
    int rays() {
        return view.columns();
    }

    @Override
    Blobs measure(World world, Body robot) {
        return image(view.look(world, robot, shift(), part.rangeMax()));
    }

    private Blobs image(Sight sight) {
        var blobs = new ArrayList<Blob>();
        int column = 0;
        while (column < part.width()) {
            Rgb color = color(sight.surface(column));
            int end = column + 1;
            while (end < part.width() && color != null && color.equals(color(sight.surface(end)))) {
                end++;
            }
            if (color != null) {
                blobs.add(blob(color, sight, column, end));
            }
            column = end;
        }
        return new Blobs(shift().moved(part.baseFromCamera()), part.width(), part.height(), part.fieldOfView(), blobs);
    }

    /// Null when it is nothing to tell of.
    private @Nullable Rgb color(@Nullable Surface surface) {
        if (surface == null || !surface.blob()) {
            return null;
        }
        return part.colors().isEmpty() || part.colors().contains(surface.color()) ? surface.color() : null;
    }

    private Blob blob(Rgb color, Sight sight, int left, int right) {
        int top = part.height();
        int bottom = 0;
        int area = 0;
        double x = 0;
        double y = 0;
        double range = 0;
        for (int column = left; column < right; column++) {
            int first =
                    Math.clamp((long) Math.floor(row(sight.high(column), sight.range(column))), 0, part.height() - 1);
            int end =
                    Math.clamp((long) Math.ceil(row(sight.low(column), sight.range(column))), first + 1, part.height());
            top = Math.min(top, first);
            bottom = Math.max(bottom, end);
            area += end - first;
            x += (end - first) * (column + 0.5);
            y += (end - first) * (first + end) / 2.0;
            range += sight.range(column) / (right - left);
        }
        return new Blob(color, left, top, right, bottom, x / area, y / area, area, range);
    }

    /// @param above the camera [m]
    private double row(double above, double range) {
        return part.height() / 2.0 - StrictMath.atan2(above, range) * part.width() / part.fieldOfView();
    }
}
