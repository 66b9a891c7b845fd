package rsal.player.bridge;

import rsal.data.BatteryState;
import rsal.data.Stamped;
import rsal.device.Battery;
import rsal.player.message.Interface;
import rsal.player.message.Power;
import rsal.time.Scheduler;

/// A battery as `power`.
final class OfferedBattery extends OfferedSensor<BatteryState> {
    OfferedBattery(int index, Battery battery, Scheduler scheduler) {
        super(Interface.POWER, index, battery, scheduler);
    }

    @Override
    void publish(Stamped<BatteryState> reading) {
        BatteryState state = reading.value();
        int valid = Power.IS_CHARGING
                | valid(state.voltage(), Power.VOLTS)
                | valid(state.power(), Power.WATTS)
                | valid(state.charge(), Power.JOULES)
                | valid(state.level(), Power.PERCENT);
        int charging = switch (state.charging()) {
            case CHARGING -> 1;
            case GIVING -> -1;
            case DISCHARGING, FULL, UNKNOWN -> 0;
        };
        publish(
                Power.STATE,
                reading.time(),
                new Power.State(
                        valid,
                        number(state.voltage()),
                        number(100 * state.level()),
                        number(state.charge()),
                        number(state.power()),
                        charging));
    }

    private static int valid(double value, int bit) {
        return Double.isFinite(value) ? bit : 0;
    }

    private static float number(double value) {
        return Double.isFinite(value) ? (float) value : 0;
    }
}
