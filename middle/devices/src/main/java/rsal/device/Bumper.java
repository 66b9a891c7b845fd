package rsal.device;

import rsal.data.BumperState;

/// Feels what the robot touches. Frame of its readings: `<robot>/base_link`.
public interface Bumper extends Sensor<BumperState> {}
