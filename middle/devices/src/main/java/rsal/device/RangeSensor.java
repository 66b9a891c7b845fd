package rsal.device;

/// What measures how far things around a robot are, by whatever means: a [LaserScanner] or a [SonarArray]. Who will
/// do with either asks for this.
public interface RangeSensor extends Device {}
