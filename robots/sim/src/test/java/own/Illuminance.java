package own;

import rsal.data.Unit;

/// How bright it is.
///
/// @param illuminance on a level surface [lx]
public record Illuminance(@Unit("lx") double illuminance) {}
