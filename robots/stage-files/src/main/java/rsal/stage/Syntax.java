package rsal.stage;

import java.util.List;
import java.util.Map;
import rsal.settings.Location;
import rsal.stage.WorldfileEntity.Setting;

/// An entity as it is written, macros not yet put in.
///
/// @param name its type, or the macro that it is made of
record Syntax(String name, Location location, Map<String, Setting> settings, List<Syntax> children) {}
