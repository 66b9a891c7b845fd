package rsal.gazebo;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.settings.Location;
import rsal.settings.Problem;

/// What of a world is left out, or taken for something else: each kind is told once, at its first place, with how
/// many there are.
final class SdfNotes {
    private static final int MOST = 200; // kinds

    private final Map<String, Note> notes = new LinkedHashMap<>();
    private int omitted;

    private static final class Note {
        private final Problem first;
        private int count = 1;

        Note(Problem first) {
            this.first = first;
        }

        Problem problem() {
            return count == 1
                    ? first
                    : new Problem(
                            first.location(),
                            "%s So %s %d more.".formatted(first.message(), count == 2 ? "is" : "are", count - 1),
                            first.remedy());
        }
    }

    /// @param kind what is told once
    /// @param message about one, which "So are 3 more." can follow
    void add(String kind, Location at, String message, String remedy) {
        Note known = notes.get(kind);
        if (known != null) {
            known.count++;
        } else if (notes.size() < MOST) {
            notes.put(kind, new Note(new Problem(at, message, remedy)));
        } else {
            omitted++;
        }
    }

    /// @param file the world's, for what is said of all of it
    List<Problem> all(String file) {
        var all = new ArrayList<>(notes.values().stream().map(Note::problem).toList());
        if (omitted > 0) {
            all.add(new Problem(Location.of(file), "There are %d more notes.".formatted(omitted), ""));
        }
        return List.copyOf(all);
    }
}
