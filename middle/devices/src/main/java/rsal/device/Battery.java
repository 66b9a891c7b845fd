package rsal.device;

import rsal.data.BatteryState;

/// A robot's store of energy. Frame of its readings: `<robot>/base_link`.
public interface Battery extends Sensor<BatteryState> {}
