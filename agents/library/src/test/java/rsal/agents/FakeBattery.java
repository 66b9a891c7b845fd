package rsal.agents;

import java.time.Instant;
import rsal.data.BatteryState;
import rsal.data.Stamped;
import rsal.device.Battery;
import rsal.device.DeviceInfo;
import rsal.device.SensorCore;

/// A battery whose charge a test sets.
public final class FakeBattery extends SensorCore<BatteryState> implements Battery {
    public FakeBattery(String robot) {
        super(new DeviceInfo(robot, "battery", "fake"));
    }

    public void is(double level, BatteryState.Charging charging, Instant time) {
        deliver(new Stamped<>(time, info().robot() + "/base_link", BatteryState.of(level, 1, 0, charging)));
    }
}
