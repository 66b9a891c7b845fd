package rsal.sim;

import java.time.Instant;
import java.util.List;
import rsal.data.Fan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.device.DeviceInfo;
import rsal.device.SonarArray;
import rsal.robot.RobotModel.Part.Sonars;
import rsal.sim.world.Body;
import rsal.sim.world.SensorRays;
import rsal.sim.world.World;

/// A simulated ring of sonars. Each cone is a [fan][Fan#cone], and its range that of the shortest ray. Level, all of
/// them.
final class SimSonar extends NoisyRangeSensor<RangeArray> implements SonarArray {
    private final Sonars sonars;
    private final SensorRays cones;
    private final int raysOfEach;

    /// @param cones made by [#cones]
    SimSonar(DeviceInfo info, Sonars sonars, SensorRays cones, DeviceMount mount, Noise noise) {
        super(info, info.robot() + "/base_link", sonars.period(), mount, noise);
        this.sonars = sonars;
        this.cones = cones;
        this.raysOfEach = cones.count() / sonars.baseFromSensors().size();
    }

    /// @param height above the base [m]
    static SensorRays cones(Sonars sonars, double height) {
        return new SensorRays(
                sonars.baseFromSensors().stream()
                        .map(baseFromSensor -> Fan.cone(baseFromSensor, sonars.fieldOfView()))
                        .toList(),
                height);
    }

    @Override
    int rays() {
        return cones.count();
    }

    @Override
    RangeArray measure(World world, Body robot, Instant now) {
        float[] ranges = new float[sonars.baseFromSensors().size()];
        double[] distances = cones.cast(world, robot, shift(), sonars.rangeMax());
        for (int i = 0; i < ranges.length; i++) {
            double shortest = Double.POSITIVE_INFINITY;
            for (int ray = i * raysOfEach; ray < (i + 1) * raysOfEach; ray++) {
                shortest = Math.min(shortest, distances[ray]);
            }
            ranges[i] = shown(shortest, sonars.rangeMin(), sonars.rangeMax());
        }
        List<Pose2d> baseFromSensors = shift().isNone()
                ? sonars.baseFromSensors()
                : sonars.baseFromSensors().stream().map(shift()::moved).toList();
        return new RangeArray(baseFromSensors, sonars.fieldOfView(), sonars.rangeMin(), sonars.rangeMax(), ranges);
    }
}
