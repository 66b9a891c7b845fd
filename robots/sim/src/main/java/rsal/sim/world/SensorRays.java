package rsal.sim.world;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.function.Predicate;
import rsal.data.Fan;
import rsal.data.Pose2d;
import rsal.robot.Shift;

/// All rays of a sensor: those of a laser scanner, which leave one place, or those of a ring of sonars. Robots of one
/// kind share them.
public final class SensorRays {
    private static final double TURN = 2 * Math.PI;
    private static final int FEW = 3; // rays of a fan that are not worth asking which of them meet a body

    private final double[] originX; // of each fan, in the base frame [m]
    private final double[] originY;
    private final double[] heading; // of each fan's first ray, in the base frame [rad]
    private final double[] increment; // between the rays of each fan [rad]
    private final int[] begin; // of each fan, the index of its first ray; one more for the end
    private final double height;
    private final double farthestOrigin;
    private final double[] cos; // of each ray, in the base frame
    private final double[] sin;

    /// @param height of the sensor above its body's base [m]
    public SensorRays(List<Fan> fans, double height) {
        this.height = height;
        originX = fans.stream().mapToDouble(fan -> fan.baseFromSensor().x()).toArray();
        originY = fans.stream().mapToDouble(fan -> fan.baseFromSensor().y()).toArray();
        heading = fans.stream()
                .mapToDouble(fan -> fan.baseFromSensor().theta() + fan.first())
                .toArray();
        increment = fans.stream().mapToDouble(Fan::increment).toArray();
        begin = new int[fans.size() + 1];
        double farthest = 0;
        for (int i = 0; i < fans.size(); i++) {
            begin[i + 1] = begin[i] + fans.get(i).count();
            farthest = Math.max(farthest, Math.hypot(originX[i], originY[i]));
        }
        farthestOrigin = farthest;
        int count = begin[fans.size()];
        cos = new double[count];
        sin = new double[count];
        for (int fan = 0; fan < fans.size(); fan++) {
            for (int i = begin[fan]; i < begin[fan + 1]; i++) {
                double angle = heading[fan] + (i - begin[fan]) * increment[fan];
                cos[i] = StrictMath.cos(angle);
                sin[i] = StrictMath.sin(angle);
            }
        }
    }

    public int count() {
        return cos.length;
    }

    /// How far each ray gets before it meets a wall or another robot as [World#look] saw it [m], fan by fan; +∞
    /// beyond reach.
    ///
    /// @param self whose sensor it is, where sensors see it; rays pass through it
    /// @return the first [#count] of it; overwritten by this thread's next cast
    public double[] cast(World world, Body self, double reach) {
        return cast(world, self, Shift.NONE, reach);
    }

    /// The same, of a sensor that has been carried along.
    public double[] cast(World world, Body self, Shift shift, double reach) {
        return cast(world, self, shift, reach, 0, () -> 0);
    }

    /// The same, of rays each of which is a little off.
    ///
    /// @param most how far at most, either way [rad]; 0: not at all
    /// @param turn how far the next ray is [rad]
    public double[] cast(World world, Body self, Shift shift, double reach, double most, DoubleSupplier turn) {
        Figure base = self.seen.shifted(shift);
        double z = base.height() + height;
        Rays rays = Rays.ofThisThread(cos.length);
        aim(rays, base);
        if (most > 0) {
            turn(rays, turn);
        }
        meet(world.sensorView(), rays, base, z, reach, most, owner -> owner == self);
        for (RasterWalls walls : world.walls()) {
            if (walls.surface().seenByRangers() && walls.isAt(z)) {
                walls.end(rays, reach);
            }
        }
        return rays.range;
    }

    /// The same from anywhere, through walls.
    ///
    /// @param through whom rays pass
    /// @return a copy
    public double[] castThroughWalls(World world, Pose2d mapFromBase, double reach, Predicate<Body> through) {
        var base = new Figure(List.of());
        base.placeAt(mapFromBase, 0);
        Rays rays = Rays.ofThisThread(cos.length);
        aim(rays, base);
        meet(world.sensorView(), rays, base, height, reach, 0, through);
        return Arrays.copyOf(rays.range, cos.length);
    }

    /// Ends rays at bodies.
    private void meet(
            SensorView seen, Rays rays, Figure base, double z, double reach, double astray, Predicate<Body> through) {
        PieceGrid.Found near = rays.near;
        seen.near(base.pose().x(), base.pose().y(), reach + farthestOrigin, near);
        for (int i = 0; i < near.count; i++) {
            int slot = near.slots[i];
            PlacedShape piece = seen.piece(slot);
            if (piece.surface.seenByRangers() && piece.isAt(z) && !through.test(seen.owner(slot))) {
                for (int fan = 0; fan < originX.length; fan++) {
                    clip(rays, slot, piece, base, fan, reach, astray);
                }
            }
        }
    }

    private void aim(Rays rays, Figure base) {
        double baseCos = base.cos();
        double baseSin = base.sin();
        for (int fan = 0; fan < originX.length; fan++) {
            double x = base.pose().x() + baseCos * originX[fan] - baseSin * originY[fan];
            double y = base.pose().y() + baseSin * originX[fan] + baseCos * originY[fan];
            for (int i = begin[fan]; i < begin[fan + 1]; i++) {
                rays.x[i] = x;
                rays.y[i] = y;
                rays.dx[i] = baseCos * cos[i] - baseSin * sin[i];
                rays.range[i] = Double.POSITIVE_INFINITY;
                rays.met[i] = Rays.NOTHING;
                rays.dy[i] = baseSin * cos[i] + baseCos * sin[i];
            }
        }
    }

    private void turn(Rays rays, DoubleSupplier turn) {
        for (int i = 0; i < cos.length; i++) {
            double angle = turn.getAsDouble();
            double c = StrictMath.cos(angle);
            double s = StrictMath.sin(angle);
            double dx = rays.dx[i];
            rays.dx[i] = c * dx - s * rays.dy[i];
            rays.dy[i] = s * dx + c * rays.dy[i];
        }
    }

    /// Ends the rays of a fan at a piece, looking only at those that may meet the circle around it.
    private void clip(Rays rays, int slot, PlacedShape piece, Figure base, int fan, double reach, double astray) {
        int last = begin[fan + 1] - begin[fan] - 1;
        double toX = piece.x() - rays.x[begin[fan]];
        double toY = piece.y() - rays.y[begin[fan]];
        double square = toX * toX + toY * toY;
        if (last < FEW || square <= piece.radius() * piece.radius()) {
            clip(rays, slot, piece, reach, begin[fan], begin[fan] + last);
            return;
        }
        double ahead = base.cos() * toX + base.sin() * toY; // in the base frame
        double aside = base.cos() * toY - base.sin() * toX;
        double halfWidth = RoughAngles.asinAtLeast(piece.radius() / Math.sqrt(square)) + RoughAngles.ERROR + astray;
        double bearing = RoughAngles.atan2(aside, ahead) - heading[fan];
        double start = bearing - halfWidth - TURN * Math.floor((bearing + halfWidth) / TURN); // its end is in [0, 2π)
        double perRay = 1 / increment[fan];
        for (double turned = start; turned <= last * increment[fan]; turned += TURN) {
            int from = Math.max(0, (int) Math.ceil(turned * perRay));
            int to = Math.min(last, (int) Math.floor((turned + 2 * halfWidth) * perRay));
            clip(rays, slot, piece, reach, begin[fan] + from, begin[fan] + to);
        }
    }

    private void clip(Rays rays, int slot, PlacedShape piece, double reach, int from, int to) {
        double square = piece.radius() * piece.radius();
        for (int i = from; i <= to; i++) {
            double aside = (piece.x() - rays.x[i]) * rays.dy[i] - (piece.y() - rays.y[i]) * rays.dx[i];
            if (aside * aside <= square) {
                double range = piece.ray(rays.x[i], rays.y[i], rays.dx[i], rays.dy[i]);
                if (range < rays.range[i] && range <= reach) {
                    rays.range[i] = range;
                    rays.met[i] = slot;
                }
            }
        }
    }
}
