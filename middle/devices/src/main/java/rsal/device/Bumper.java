package rsal.device;

import rsal.data.BumperState;

/// Detects contacts of the robot. Frame of its readings: `<robot>/base_link`.
public interface Bumper extends Sensor<BumperState> {}
