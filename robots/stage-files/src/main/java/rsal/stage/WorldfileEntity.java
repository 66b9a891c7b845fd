package rsal.stage;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.settings.Location;
import rsal.settings.Value;

/// A model, a part of one (`block`, `sensor`), or the `window`, after macros were put in.
///
/// @param type what it is in the end: `position`, `block`
/// @param macro what it was written as: `pioneer2dx`; the type when no macro was used
/// @param location where its type or macro is written
/// @param settings by name, in the order of the file; of those of one name the last, the instance's before the
/// macro's. Not to be changed
/// @param children the macro's before the instance's own. Not to be changed; macros share them
/// @param make the entity of which this is a copy at another place and of another name; empty when it is
/// more or less than that
/// @param size how many entities this is with all that is in it
public record WorldfileEntity(
        String type,
        String macro,
        Location location,
        Map<String, Setting> settings,
        List<WorldfileEntity> children,
        Optional<WorldfileEntity> make,
        long size) {

    /// A property.
    ///
    /// @param location of its name
    public record Setting(String name, Location location, Value value) {}

    public Optional<Setting> find(String name) {
        return Optional.ofNullable(settings.get(name));
    }
}
