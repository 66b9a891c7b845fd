package rsal.stage;

import java.util.Set;
import java.util.TreeSet;

/// A kind of files that are written like worlds.
///
/// @param types of entities that macros can build upon
/// @param dropped types that older versions knew
/// @param player whether names may have colons, and `true`, `false`, `yes` and `no` are values
public record Dialect(Set<String> types, Set<String> dropped, boolean player) {
    static final Dialect STAGE = new Dialect(Types.ALL, Types.obsolete(), false);

    /// Configurations of Player's servers.
    public static final Dialect PLAYER =
            new Dialect(new TreeSet<>(Set.of("driver", "interface", "server")), Set.of(), true);
}
