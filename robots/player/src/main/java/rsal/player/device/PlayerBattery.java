package rsal.player.device;

import java.util.Optional;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.device.Battery;
import rsal.device.DeviceInfo;
import rsal.player.message.Power;
import rsal.player.wire.Address;

/// A battery behind `power`. Its capacity follows from what is left, if both that and its share are told.
final class PlayerBattery extends PlayerSensor<BatteryState> implements Battery {
    PlayerBattery(DeviceInfo info, Address address) {
        super(info, address, info.robot() + "/base_link");
    }

    @Override
    Optional<BatteryState> read(Record body) {
        if (!(body instanceof Power.State state)) {
            return Optional.empty();
        }
        double charge = valid(state, Power.JOULES, state.joules());
        double level = valid(state, Power.PERCENT, state.percent()) / 100;
        double power = valid(state, Power.WATTS, state.watts());
        return Optional.of(new BatteryState(
                charge,
                level > 0 ? charge / level : Double.NaN,
                level,
                power,
                valid(state, Power.VOLTS, state.volts()),
                charging(state, level, power)));
    }

    private static double valid(Power.State state, int bit, float value) {
        return (state.valid() & bit) == 0 ? Double.NaN : value;
    }

    private static Charging charging(Power.State state, double level, double power) {
        if ((state.valid() & Power.IS_CHARGING) == 0) {
            return Charging.UNKNOWN;
        }
        return switch (state.charging()) {
            case 1 -> Charging.CHARGING;
            case -1 -> Charging.GIVING;
            default -> power < 0 || level < 1 ? Charging.DISCHARGING : Charging.FULL;
        };
    }
}
