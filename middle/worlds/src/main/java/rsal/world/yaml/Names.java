package rsal.world.yaml;

import java.util.HashSet;
import java.util.Set;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;

/// What things and robots of a world are called, each by a name of its own, and how much of it there is.
final class Names {
    private static final int MAX_ENTITIES = 200_000;
    private static final int MAX_PIECES = 2_000_000;
    private static final int MAX_LENGTH = 200; // of a name
    private static final String WALL = "wall"; // what robots run into when it is no body

    private final Set<String> taken = new HashSet<>();
    private final Problems problems;
    private long pieces;

    Names(Problems problems) {
        this.problems = problems;
    }

    /// @param pieces of its body
    /// @throws InvalidSettings when there is too much to go on
    void claim(String name, int pieces, Location at) {
        this.pieces += pieces;
        if (taken.size() >= MAX_ENTITIES || this.pieces > MAX_PIECES) {
            throw new InvalidSettings(
                    at,
                    "The world has more than %d things and robots, or %d pieces.".formatted(MAX_ENTITIES, MAX_PIECES),
                    "Maybe a 'count' is too large.");
        }
        if (name.isBlank() || name.length() > MAX_LENGTH || name.equals(WALL)) {
            problems.add(at, "'%s' can't be a name here.".formatted(name), "");
        } else if (!taken.add(name)) {
            problems.add(at, "There are two of the name '%s'.".formatted(name), "Rename one of them.");
        }
    }
}
