package rsal.sim;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import rsal.data.Blobs;
import rsal.data.Rgb;
import rsal.device.BlobFinder;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.scene.Surface;
import rsal.sim.world.Body;
import rsal.sim.world.CameraRays;
import rsal.sim.world.ColumnRenderer;
import rsal.sim.world.World;

/// A simulated camera that finds patches of color: each pixel has the color of what its ray meets first
/// ([CameraRays]), and [BlobExtractor] joins them. (Stage has one level ray a column, and takes everything for
/// 0.6 m high.)
final class SimBlobFinder extends SimRangeSensor<Blobs> implements BlobFinder {
    private final Part.BlobFinder part;
    private final CameraRays view;

    /// @param view made by [#view]
    SimBlobFinder(DeviceInfo info, Part.BlobFinder part, CameraRays view, DeviceMount mount) {
        super(info, info.id(), part.period(), mount);
        this.part = part;
        this.view = view;
    }

    /// @param height above the base [m]
    static CameraRays view(Part.BlobFinder part, double height) {
        return new CameraRays(part.baseFromCamera(), part.width(), part.height(), part.fieldOfView(), height);
    }

    @Override
    int rays() {
        return view.columns();
    }

    @Override
    Blobs measure(World world, Body robot, Instant now) {
        ColumnRenderer sight = view.look(world, robot, shift(), part.rangeMax());
        BlobExtractor patches = BlobExtractor.ofThisThread();
        for (int i = 0; i < sight.count(); i++) {
            Rgb color = color(sight.surface(i));
            if (color != null) {
                patches.add(color, sight.column(i), sight.first(i), sight.end(i), sight.distances(i));
            }
        }
        return new Blobs(
                shift().moved(part.baseFromCamera()), part.width(), part.height(), part.fieldOfView(), patches.blobs());
    }

    /// Null when it is none of those looked for.
    private @Nullable Rgb color(Surface surface) {
        return part.colors().isEmpty() || part.colors().contains(surface.color()) ? surface.color() : null;
    }
}
