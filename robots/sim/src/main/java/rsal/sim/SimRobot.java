package rsal.sim;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.device.Device;
import rsal.device.Health;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scene.Touch;
import rsal.sim.world.Arc;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// A robot of the simulated world: its body there, and its devices.
///
/// @param devices all but the drive, in the order of its model
/// @param eyes those devices that look into the distance
/// @param parts those devices that feel or move, actuators before what may stand on them
/// @param mounts of devices that actuators carry
record SimRobot(
        RobotSpec spec,
        Body body,
        SimDrive drive,
        List<SimSensor<?>> devices,
        List<SimRangeSensor<?>> eyes,
        List<SimActuatedDevice<?>> parts,
        List<DeviceMount> mounts) {

    static SimRobot of(
            RobotSpec spec, Body body, SimDrive drive, List<SimSensor<?>> devices, List<DeviceMount> mounts) {
        var eyes = new ArrayList<SimRangeSensor<?>>();
        var parts = new ArrayList<SimActuatedDevice<?>>();
        for (SimSensor<?> device : devices) {
            if (device instanceof SimRangeSensor<?> eye) {
                eyes.add(eye);
            } else if (device instanceof SimActuatedDevice<?> part) {
                parts.add(part);
            }
        }
        parts.sort(Comparator.comparing(part -> !(part instanceof SimActuator)));
        return new SimRobot(
                spec, body, drive, List.copyOf(devices), List.copyOf(eyes), List.copyOf(parts), List.copyOf(mounts));
    }

    String id() {
        return spec.id();
    }

    /// What others get to see of it.
    Robot robot() {
        var all = new ArrayList<Device>();
        all.add(drive);
        devices.forEach(device -> all.add(device.device()));
        return new Robot(spec.id(), spec.role(), spec.model(), spec.marker(), all);
    }

    /// Drives for a step, or until it would touch something; then it stalls or slides.
    ///
    /// @param dt [s]
    /// @return whether it touched nothing; when it did, [World#obstacle] says what
    boolean move(World world, double dt, Touch touch) {
        WheelSpeeds wheels = drive.turnWheels(dt);
        var arc = new Arc(body.pose(), wheels.forward(), wheels.left(), wheels.turn());
        double made = world.advance(body, arc);
        boolean slides = made < 1 && touch == Touch.SLIDE && world.slide(body, arc, made);
        drive.moved(slides ? 1 : made);
        return made == 1;
    }

    /// Lets those devices work that feel or move.
    ///
    /// @param dt [s]
    /// @param ranInto told what its arms touched; empty for a wall
    void work(Instant now, double dt, Consumer<Optional<Body>> ranInto) {
        for (SimActuatedDevice<?> part : parts) {
            part.work(now, dt);
            if (part instanceof SimActuator actuator) {
                actuator.stopped().map(SimActuator.Stop::by).ifPresent(ranInto);
            }
        }
    }

    /// From now on its sensors look from where actuators have carried them now.
    void lookFromHere() {
        for (DeviceMount mount : mounts) {
            mount.look();
        }
    }

    /// How many rays its sensors cast when they look now.
    int raysDue(Instant now) {
        int rays = 0;
        for (SimRangeSensor<?> eye : eyes) {
            rays += eye.isDue(now) ? eye.rays() : 0;
        }
        return rays;
    }

    /// Takes those readings that are due.
    void look(World world, Instant now) {
        for (SimRangeSensor<?> eye : eyes) {
            if (eye.isDue(now)) {
                eye.look(world, body, now);
            }
        }
    }

    void report(Instant now) {
        drive.report(now);
        devices.forEach(SimSensor::report);
    }

    /// What it holds stays where it is.
    void leaveBehind() {
        for (SimActuatedDevice<?> part : parts) {
            if (part instanceof SimGripper gripper) {
                gripper.leaveBehind();
            }
        }
    }

    void close(Health.Lost why) {
        drive.close(why);
        devices.forEach(device -> device.close(why));
    }
}
