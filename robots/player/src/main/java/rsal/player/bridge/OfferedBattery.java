package rsal.player.bridge;

import java.util.Optional;
import rsal.data.BatteryState;
import rsal.data.Stamped;
import rsal.device.Battery;
import rsal.device.Subscription;
import rsal.player.message.Interface;
import rsal.player.message.Power;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A battery as `power`.
final class OfferedBattery extends Offered {
    private final Battery battery;

    OfferedBattery(int index, Battery battery, Scheduler scheduler) {
        super(Interface.POWER, index, battery.info(), scheduler);
        this.battery = battery;
    }

    @Override
    Subscription listen() {
        return battery.subscribe(this::tell);
    }

    private void tell(Stamped<BatteryState> reading) {
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

    @Override
    Optional<Answer> answer(Packet request) {
        return Optional.empty();
    }
}
