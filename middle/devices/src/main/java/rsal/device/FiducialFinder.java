package rsal.device;

import rsal.data.Fiducials;

/// Detects markers. No marker in view is a reading, too. Frame of its readings: `<robot>/base_link`.
public interface FiducialFinder extends Sensor<Fiducials> {}
