package rsal.device.gnss;

import rsal.device.Sensor;

/// A receiver of satellite navigation (GNSS). Frame of its readings: `map`.
public interface Gnss extends Sensor<GnssFix> {}
