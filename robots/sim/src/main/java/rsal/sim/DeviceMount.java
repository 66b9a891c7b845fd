package rsal.sim;

import java.util.List;
import rsal.robot.Shift;

/// What devices stand on: the base of their robot, or an actuator, which may stand on another one.
final class DeviceMount {
    static final DeviceMount BASE = new DeviceMount(List.of());

    private final List<SimActuator> actuators;
    private Shift seen = Shift.NONE;

    /// @param actuators from the base outwards
    DeviceMount(List<SimActuator> actuators) {
        this.actuators = actuators;
    }

    /// How far what stands on it has been carried.
    Shift now() {
        Shift shift = Shift.NONE;
        for (SimActuator actuator : actuators) {
            shift = shift.compose(actuator.shift());
        }
        return shift;
    }

    /// From now on sensors that stand on it look from where it is now, whatever moves while they look.
    void look() {
        seen = now();
    }

    /// How far it had been carried at the last [#look].
    Shift seen() {
        return seen;
    }
}
