package rsal.sim.world;

import rsal.data.Pose2d;

/// Rays that leave one point at equal angles: the beams of a laser scanner, or the cone of a sonar.
public final class Fan {
    private static final double TURN = 2 * Math.PI;

    private final double first;
    private final double increment;
    private final double[] cos; // of each ray in the sensor's frame
    private final double[] sin;
    private final double[] directionX; // of each ray in the map
    private final double[] directionY;
    private final double[] ranges;

    /// @param first direction of the first ray in the sensor's frame [rad]
    /// @param increment angle between rays, counter-clockwise [rad]; positive
    public Fan(double first, double increment, int count) {
        this.first = first;
        this.increment = increment;
        cos = new double[count];
        sin = new double[count];
        directionX = new double[count];
        directionY = new double[count];
        ranges = new double[count];
        for (int i = 0; i < count; i++) {
            cos[i] = StrictMath.cos(first + i * increment);
            sin[i] = StrictMath.sin(first + i * increment);
        }
    }

    public int count() {
        return ranges.length;
    }

    /// How far each ray gets before it meets a wall or another robot as [World#look] saw it [m]; +∞ beyond reach.
    ///
    /// @param self whose sensor it is; rays pass through it
    /// @param mapFromSensor where the rays start
    /// @return overwritten by the next cast
    public double[] cast(World world, Body self, Pose2d mapFromSensor, double reach) {
        aim(mapFromSensor.theta());
        Walls walls = world.walls();
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = walls.ray(mapFromSensor.x(), mapFromSensor.y(), directionX[i], directionY[i], reach);
        }
        var bodies = world.bodies();
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i) != self) {
                clip(bodies.get(i).seen, mapFromSensor, reach);
            }
        }
        return ranges;
    }

    private void aim(double heading) {
        double headingCos = StrictMath.cos(heading);
        double headingSin = StrictMath.sin(heading);
        for (int i = 0; i < ranges.length; i++) {
            directionX[i] = headingCos * cos[i] - headingSin * sin[i];
            directionY[i] = headingSin * cos[i] + headingCos * sin[i];
        }
    }

    /// Ends the rays at a robot, looking only at those that may meet the circle around it.
    private void clip(Outline robot, Pose2d mapFromSensor, double reach) {
        double toX = robot.x() - mapFromSensor.x();
        double toY = robot.y() - mapFromSensor.y();
        double distance = Math.sqrt(toX * toX + toY * toY);
        if (distance - robot.radius() > reach) {
            return;
        }
        int last = ranges.length - 1;
        if (distance <= robot.radius()) {
            clip(robot, mapFromSensor, reach, 0, last);
            return;
        }
        double halfWidth = StrictMath.asin(robot.radius() / distance);
        double bearing = StrictMath.atan2(toY, toX) - mapFromSensor.theta() - first;
        double begin = bearing - halfWidth - TURN * Math.floor((bearing + halfWidth) / TURN); // its end is in [0, 2π)
        for (double turned = begin; turned <= last * increment; turned += TURN) {
            int from = (int) Math.max(0, Math.ceil(turned / increment));
            int to = (int) Math.min(last, Math.floor((turned + 2 * halfWidth) / increment));
            clip(robot, mapFromSensor, reach, from, to);
        }
    }

    private void clip(Outline robot, Pose2d mapFromSensor, double reach, int from, int to) {
        for (int i = from; i <= to; i++) {
            double range = robot.ray(mapFromSensor.x(), mapFromSensor.y(), directionX[i], directionY[i]);
            if (range < ranges[i] && range <= reach) {
                ranges[i] = range;
            }
        }
    }
}
