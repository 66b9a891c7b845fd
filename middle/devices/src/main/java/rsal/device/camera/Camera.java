package rsal.device.camera;

import rsal.device.Sensor;

/// A camera that sees colors and depth (RGB-D). Frame of its readings: `<robot>/<device>`, x ahead, as of all
/// devices of RSAL (REP 103); ROS's optical frame has z ahead.
public interface Camera extends Sensor<CameraImage> {}
