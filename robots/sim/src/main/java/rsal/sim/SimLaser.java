package rsal.sim;

import java.time.Instant;
import java.util.List;
import rsal.data.Fan;
import rsal.data.LaserScan;
import rsal.device.DeviceInfo;
import rsal.device.LaserScanner;
import rsal.robot.RobotModel.Part.Laser;
import rsal.sim.world.Body;
import rsal.sim.world.SensorRays;
import rsal.sim.world.World;

/// A simulated laser scanner. All beams of a sweep are taken at once, level at the height of the scanner.
final class SimLaser extends NoisyRangeSensor<LaserScan> implements LaserScanner {
    private final Laser laser;
    private final SensorRays beams;

    /// @param beams made by [#beams]
    SimLaser(DeviceInfo info, Laser laser, SensorRays beams, DeviceMount mount, Noise noise) {
        super(info, info.id(), laser.period(), mount, noise);
        this.laser = laser;
        this.beams = beams;
    }

    /// @param height above the base [m]
    static SensorRays beams(Laser laser, double height) {
        return new SensorRays(
                List.of(new Fan(laser.baseFromLaser(), laser.angleMin(), laser.angleIncrement(), laser.samples())),
                height);
    }

    @Override
    int rays() {
        return beams.count();
    }

    @Override
    LaserScan measure(World world, Body robot, Instant now) {
        double[] distances = beams.cast(
                world, robot, shift(), laser.rangeMax(), noise().size().angle(), noise()::turn);
        float[] ranges = new float[beams.count()];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = shown(distances[i], laser.rangeMin(), laser.rangeMax());
        }
        return new LaserScan(
                shift().moved(laser.baseFromLaser()),
                laser.angleMin(),
                laser.angleIncrement(),
                laser.rangeMin(),
                laser.rangeMax(),
                ranges);
    }
}
