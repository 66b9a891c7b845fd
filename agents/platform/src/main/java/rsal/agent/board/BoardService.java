package rsal.agent.board;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.ServiceDescription;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Subscribe;

/// What masters and the others say to each other about one board.
final class BoardService {
    private static final String CAPABILITY = "blackboard";
    private static final String BOARD = "board";

    /// How many notes there are in one message.
    static final int MOST_AT_ONCE = 64;

    private BoardService() {}

    static ServiceDescription capability(String board) {
        return new ServiceDescription(CAPABILITY, Map.of(BOARD, board));
    }

    /// Those that keep a board, in the order in which they started; all but the first stand by.
    static List<String> keepers(Directory directory, String board) {
        return directory.offering(CAPABILITY).stream()
                .map(Directory.Entry::name)
                .filter(name -> directory.capabilities(name).contains(capability(board)))
                .toList();
    }

    static Request<Writing, Written> writing(AgentContext self, String board) {
        return new Request<>(self, "write " + board, Writing.class, Written.class);
    }

    static Request<Asking, Answer> asking(AgentContext self, String board) {
        return new Request<>(self, "ask " + board, Asking.class, Answer.class);
    }

    static Subscribe<Asking, Changes> watching(AgentContext self, String board) {
        return new Subscribe<>(self, "watch " + board, Asking.class, Changes.class);
    }

    /// What an author has changed.
    ///
    /// @param session when its end of the board was made
    /// @param number counts what was said in that session, from 1; one with a lower number is told too late
    record Writing(Instant session, long number, List<Note<?>> notes, List<Note.Name> erased) {
        Writing {
            notes = List.copyOf(notes);
            erased = List.copyOf(erased);
        }

        boolean isAfter(Instant lastSession, long lastNumber) {
            int later = session.compareTo(lastSession);
            return later > 0 || (later == 0 && number > lastNumber);
        }

        @Override
        public String toString() {
            return words(notes, erased);
        }
    }

    /// @param refused why, by the name of a note that was not taken
    record Written(Map<Note.Name, String> refused) {
        Written {
            refused = Map.copyOf(refused);
        }

        @Override
        public String toString() {
            return refused.isEmpty() ? "written" : refused.size() + " refused";
        }
    }

    /// @param watch by what one who watches knows it, also when it asks again because nothing was heard; 0 for those
    /// who ask once
    record Asking(Query<?> query, long watch) {
        @Override
        public String toString() {
            return query.toString();
        }
    }

    record Answer(List<Note<?>> notes, int left) {
        Answer {
            notes = List.copyOf(notes);
        }

        @Override
        public String toString() {
            return words(notes, List.of());
        }
    }

    /// @param anew whether what was told before this counts no more
    record Changes(boolean anew, List<Note<?>> notes, List<Note.Key> gone) {
        Changes {
            notes = List.copyOf(notes);
            gone = List.copyOf(gone);
        }

        @Override
        public String toString() {
            return words(notes, gone.stream().map(Note.Key::name).toList());
        }
    }

    /// For people: the first note, and how many there are.
    private static String words(List<Note<?>> notes, List<Note.Name> gone) {
        String first = notes.isEmpty() ? "no notes" : notes.getFirst().toString();
        String others = notes.size() > 1 ? " and %d more".formatted(notes.size() - 1) : "";
        String erased = gone.isEmpty() ? "" : "; %s%s gone".formatted(gone.getFirst(), gone.size() > 1 ? ", ..." : "");
        return first + others + erased;
    }
}
