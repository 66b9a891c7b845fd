package rsal.sim;

import rsal.data.RangeArray;
import rsal.device.DeviceInfo;
import rsal.device.SonarArray;
import rsal.robot.RobotModel.Part.Sonars;
import rsal.sim.world.Body;
import rsal.sim.world.Fan;
import rsal.sim.world.World;

/// A simulated ring of sonars. Each cone is a fan of rays at most 5° apart, and its range that of the shortest.
final class SimSonar extends RangeSensor<RangeArray> implements SonarArray {
    private static final double RAYS_APART = Math.toRadians(5);

    private final Sonars sonars;
    private final Fan cone;

    SimSonar(DeviceInfo info, Sonars sonars, Noise noise) {
        super(info, info.robot() + "/base_link", sonars.period(), noise);
        this.sonars = sonars;
        int gaps = Math.max(1, (int) Math.ceil(sonars.fieldOfView() / RAYS_APART));
        this.cone = new Fan(-sonars.fieldOfView() / 2, sonars.fieldOfView() / gaps, gaps + 1);
    }

    @Override
    int rays() {
        return cone.count() * sonars.baseFromSensors().size();
    }

    @Override
    RangeArray measure(World world, Body robot) {
        float[] ranges = new float[sonars.baseFromSensors().size()];
        for (int i = 0; i < ranges.length; i++) {
            var mapFromSensor =
                    robot.seenPose().compose(sonars.baseFromSensors().get(i));
            double shortest = Double.POSITIVE_INFINITY;
            for (double way : cone.cast(world, robot, mapFromSensor, sonars.rangeMax())) {
                shortest = Math.min(shortest, way);
            }
            ranges[i] = shown(shortest, sonars.rangeMin(), sonars.rangeMax());
        }
        return new RangeArray(
                sonars.baseFromSensors(), sonars.fieldOfView(), sonars.rangeMin(), sonars.rangeMax(), ranges);
    }
}
