package rsal.stage.playercfg;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.settings.Location;
import rsal.settings.Value;

/// A driver that a server starts.
///
/// @param location of its block
/// @param provides devices that it makes
/// @param requires devices of other drivers that it works with, maybe on other servers
/// @param plugin library that has it, when it is none of Player's own
/// @param alwaysOn whether it works though nobody asks
/// @param options all else that is said of it, by name
public record Driver(
        String name,
        Location location,
        List<DriverAddress> provides,
        List<DriverAddress> requires,
        Optional<String> plugin,
        boolean alwaysOn,
        Map<String, Option> options) {

    public Driver {
        provides = List.copyOf(provides);
        requires = List.copyOf(requires);
        options = Collections.unmodifiableMap(new LinkedHashMap<>(options));
    }

    /// @param location of its name
    /// @param value a number, a text, true or false, or a list of those, in the units of the file
    public record Option(String name, Location location, Value value) {}

    public Optional<Option> option(String option) {
        return Optional.ofNullable(options.get(option));
    }
}
