package rsal.scenario.run;

import rsal.device.Health;

/// A device as people see it.
///
/// @param name within its robot (`laser`)
/// @param driver what makes it work (`sim`, `amcl`)
/// @param type what it is (`LaserScanner`)
public record DeviceView(String name, String driver, String type, Health health) {}
