package rsal.sim;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.settings.Arguments;
import rsal.sim.world.Beams;
import rsal.sim.world.Body;
import rsal.time.Scheduler;

/// Makes robots of their parts. Robots of one kind share what does not change.
final class Assembly {
    private final Arguments settings;
    private final Scheduler scheduler;
    private final Seeds seeds;
    private final Map<Part, Beams> beams = new HashMap<>();

    Assembly(Arguments settings, Scheduler scheduler, Seeds seeds) {
        this.settings = settings;
        this.scheduler = scheduler;
        this.seeds = seeds;
    }

    SimRobot robot(RobotSpec spec, Body body) {
        var sensors = new ArrayList<RangeSensor<?>>();
        spec.model().sensors().forEach((name, part) -> sensors.add(sensor(deviceOf(spec, name), part)));
        return new SimRobot(spec, body, drive(spec), List.copyOf(sensors));
    }

    private SimDrive drive(RobotSpec spec) {
        var drive = spec.model().drive();
        return new SimDrive(
                deviceOf(spec, "base"),
                scheduler,
                settings.seconds(SimProvider.WATCHDOG.name()),
                new Wheels(drive),
                new Odometer(
                        drive.odometryNoise(),
                        settings.number(SimProvider.ODOMETRY_NOISE.name()),
                        seeds.stream(spec.id() + "/base")));
    }

    private RangeSensor<?> sensor(DeviceInfo info, Part part) {
        return switch (part) {
            case Part.Laser laser ->
                new SimLaser(
                        info,
                        laser,
                        beams.computeIfAbsent(laser, _ -> SimLaser.beams(laser)),
                        noise(info, laser.noise()));
            case Part.Sonars sonars ->
                new SimSonar(
                        info,
                        sonars,
                        beams.computeIfAbsent(sonars, _ -> SimSonar.cones(sonars)),
                        noise(info, sonars.noise()));
            default -> throw new IllegalStateException("(%s) should have been refused.".formatted(part));
        };
    }

    private RangeSensor.Noise noise(DeviceInfo info, double deviation) {
        return new RangeSensor.Noise(
                settings.number(SimProvider.SENSOR_NOISE.name()) * deviation, seeds.stream(info.id()));
    }

    private static DeviceInfo deviceOf(RobotSpec spec, String name) {
        return new DeviceInfo(spec.id(), name, SimProvider.KEY);
    }
}
