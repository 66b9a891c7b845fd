package rsal.device;

import rsal.data.RangeArray;

/// A set of single-range sensors around a robot. Frame of its readings: `<robot>/base_link`.
public interface SonarArray extends Sensor<RangeArray>, RangeSensor {}
