package rsal.device;

import rsal.data.Fiducials;

/// Finds markers; seeing none is a reading, too. Frame of its readings: `<robot>/base_link`.
public interface FiducialFinder extends Sensor<Fiducials> {}
