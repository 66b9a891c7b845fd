package rsal.sim;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import rsal.device.Device;
import rsal.device.Health;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.sim.world.Arc;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// A robot of the simulated world: its body there, and its devices.
record SimRobot(RobotSpec spec, Body body, SimDrive drive, List<RangeSensor<?>> sensors) {

    String id() {
        return spec.id();
    }

    /// What others get to see of it.
    Robot robot() {
        var devices = new ArrayList<Device>();
        devices.add(drive);
        devices.addAll(sensors);
        return new Robot(spec.id(), spec.role(), spec.model(), devices);
    }

    /// Drives for a step, or until it would touch something.
    ///
    /// @param dt [s]
    /// @return whether it made all its way; when not, [World#obstacle] says why
    boolean move(World world, double dt) {
        Wheels wheels = drive.turnWheels(dt);
        double part = world.advance(body, new Arc(body.pose(), wheels.forward(), wheels.left(), wheels.turn()));
        drive.moved(part);
        return part == 1;
    }

    /// How many rays its sensors cast when they look now.
    int raysDue(Instant now) {
        int rays = 0;
        for (RangeSensor<?> sensor : sensors) {
            rays += sensor.isDue(now) ? sensor.rays() : 0;
        }
        return rays;
    }

    /// Takes those readings that are due.
    void look(World world, Instant now) {
        for (RangeSensor<?> sensor : sensors) {
            if (sensor.isDue(now)) {
                sensor.look(world, body, now);
            }
        }
    }

    void report(Instant now) {
        drive.report(now);
        sensors.forEach(RangeSensor::report);
    }

    void close(Health.Lost why) {
        drive.close(why);
        sensors.forEach(sensor -> sensor.close(why));
    }
}
