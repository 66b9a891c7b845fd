package rsal.sim;

import java.time.Instant;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.device.Battery;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.sim.world.Body;

/// A simulated store of energy. What its robot takes follows from the way that it really made. A robot whose store is
/// empty drives on, as in Stage; who wants it to stop looks at the reading.
final class SimBattery extends SimActuatedDevice<BatteryState> implements Battery {
    private final Part.Battery part;
    private final Body robot;
    private final SimDrive drive;
    private double charge; // [J]
    private double power; // what went in less what went out in the last step [W]
    private double taken; // in this step [W]
    private double given; // in this step [W]
    private boolean offered;

    SimBattery(DeviceInfo info, Part.Battery part, Body robot, SimDrive drive) {
        super(info, info.robot() + "/base_link", part.period());
        this.part = part;
        this.robot = robot;
        this.drive = drive;
        this.charge = part.charge();
    }

    Body robot() {
        return robot;
    }

    /// Most that it gives to others besides what it gives in this step [W].
    double canGive() {
        return charge > 0 ? part.givingPower() - given : 0;
    }

    void give(double watts) {
        given += watts;
    }

    /// Something touches that would charge it.
    ///
    /// @param watts what that can give [W]
    /// @return what this takes of it [W]
    double take(double watts) {
        offered = true;
        double takes = Math.max(0, Math.min(watts, part.chargingPower() - taken));
        taken += takes;
        return takes;
    }

    /// The end of a step.
    ///
    /// @param dt [s]
    void settle(double dt) {
        double used = part.idlePower() * dt
                + part.energyPerMeter() * drive.distance()
                + part.energyPerRadian() * drive.turned();
        double before = charge;
        charge = Math.clamp(before + (taken - given) * dt - used, 0, part.capacity());
        power = (charge - before) / dt;
    }

    @Override
    void work(Instant now, double dt) {
        if (isDue(now)) {
            take(BatteryState.of(charge, part.capacity(), power, charging()), now);
        }
        taken = 0;
        given = 0;
        offered = false;
    }

    private Charging charging() {
        if (offered) {
            return charge == part.capacity() ? Charging.FULL : Charging.CHARGING;
        }
        return given > 0 ? Charging.GIVING : Charging.DISCHARGING;
    }
}
