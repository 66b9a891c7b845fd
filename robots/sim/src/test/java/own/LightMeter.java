package own;

import rsal.device.Sensor;

/// Measures how bright it is where the device is. Frame of its readings: `<robot>/<device>`.
public interface LightMeter extends Sensor<Illuminance> {}
