package rsal.system;

/// A device that a [Bridge] offers.
///
/// @param port where clients find it
/// @param name as clients know it there (`position2d:0`)
/// @param device of ours ([rsal.device.DeviceInfo#id])
public record ExportedDevice(int port, String name, String device) {}
