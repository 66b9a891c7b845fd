package rsal.sim.world;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import rsal.data.Pose2d;
import rsal.scene.Surface;

/// Looks for markers from a place, as [World#look] saw them.
public final class MarkerSearch {
    private static final double FARTHEST_PIECE = 2; // of a body with a marker, from its origin [m]

    private MarkerSearch() {}

    /// A marker in sight.
    ///
    /// @param id what is written on it
    /// @param distance of its body's origin [m]
    public record Found(int id, Pose2d mapFromMarker, double distance) {}

    /// All markers of a key of which a level ray towards their body's origin meets their body first; the nearest
    /// first.
    ///
    /// @param self who looks; rays pass through it
    /// @param z height of the rays above ground [m]
    /// @param fieldOfView around where the finder looks [rad]
    /// @param allHeights whether rays meet the marker's own body however high or low it is
    public static List<Found> markers(
            World world,
            Body self,
            Pose2d mapFromFinder,
            double z,
            double fieldOfView,
            double reach,
            int key,
            boolean allHeights) {
        var found = new ArrayList<Found>();
        for (Candidate candidate : candidates(world.sensorView(), self, mapFromFinder, reach, key)) {
            Pose2d at = candidate.body.seenPose();
            double distance = mapFromFinder.distanceTo(at);
            boolean ahead = distance == 0 || Math.abs(mapFromFinder.bearingTo(at.position())) <= fieldOfView / 2;
            if (distance <= reach && ahead && isFirst(world, self, candidate.body, mapFromFinder, z, allHeights)) {
                found.add(new Found(candidate.id, at, distance));
            }
        }
        found.sort(Comparator.comparingDouble(Found::distance).thenComparingInt(Found::id));
        return found;
    }

    private record Candidate(Body body, int id) {}

    private static Set<Candidate> candidates(SensorView seen, Body self, Pose2d from, double reach, int key) {
        var candidates = new LinkedHashSet<Candidate>();
        PieceGrid.Found near = Rays.ofThisThread(1).near;
        seen.near(from.x(), from.y(), reach + FARTHEST_PIECE, near);
        for (int i = 0; i < near.count; i++) {
            Surface surface = seen.piece(near.slots[i]).surface;
            if (surface.fiducial() != 0 && surface.fiducialKey() == key && seen.owner(near.slots[i]) != self) {
                candidates.add(new Candidate(seen.body(near.slots[i]), surface.fiducial()));
            }
        }
        return candidates;
    }

    private static boolean isFirst(
            World world, Body self, Body marker, Pose2d from, double z, boolean markerAtAllHeights) {
        Pose2d to = marker.seenPose();
        double distance = from.distanceTo(to);
        Rays rays = Rays.ofThisThread(1);
        rays.x[0] = from.x();
        rays.y[0] = from.y();
        rays.dx[0] = distance == 0 ? 1 : (to.x() - from.x()) / distance;
        rays.dy[0] = distance == 0 ? 0 : (to.y() - from.y()) / distance;
        rays.range[0] = Double.POSITIVE_INFINITY;
        SensorView seen = world.sensorView();
        PieceGrid.Found near = rays.near;
        seen.near(from.x(), from.y(), distance, near);
        Body first = null;
        for (int i = 0; i < near.count; i++) {
            PlacedShape piece = seen.piece(near.slots[i]);
            boolean meets = piece.isAt(z) || (markerAtAllHeights && seen.body(near.slots[i]) == marker);
            if (meets && seen.owner(near.slots[i]) != self) {
                double range = piece.ray(from.x(), from.y(), rays.dx[0], rays.dy[0]);
                if (range < rays.range[0]) {
                    rays.range[0] = range;
                    first = seen.body(near.slots[i]);
                }
            }
        }
        if (first != marker) {
            return false;
        }
        double toMarker = rays.range[0];
        for (RasterWalls walls : world.walls()) {
            if (walls.isAt(z)) {
                walls.end(rays, toMarker);
            }
        }
        return rays.range[0] >= toMarker;
    }
}
