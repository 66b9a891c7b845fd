package rsal.device;

/// A sensor that measures distances to obstacles around a robot: a [LaserScanner] or a [SonarArray]. Code that
/// can use either of them requires this type.
public interface RangeSensor extends Device {}
