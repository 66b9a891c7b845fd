package rsal.device;

import rsal.data.LaserScan;

/// A planar laser scanner. Frame of its readings: `<robot>/<name>`.
public interface LaserScanner extends Sensor<LaserScan>, RangeSensor {}
