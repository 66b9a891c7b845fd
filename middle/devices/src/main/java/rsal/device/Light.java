package rsal.device;

import rsal.data.LightState;
import rsal.data.LightState.Signal;

/// A light that others can see. Frame of its readings: `<robot>/<name>`.
public interface Light extends Sensor<LightState> {
    /// Shines with this signal from now until the next one. The newest wins.
    void show(Signal signal);

    default void on() {
        show(Signal.ON);
    }

    default void off() {
        show(Signal.OFF);
    }
}
