package rsal.python;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.agent.AgentContext;
import rsal.agent.Topic;
import rsal.agent.board.BoardKeeper;
import rsal.agent.board.BoardWatch;
import rsal.agent.board.Found;
import rsal.agent.board.Note;
import rsal.agent.board.Query;
import rsal.agent.board.TeamBoard;
import rsal.agent.protocol.ConversationResult;
import rsal.data.Point2d;
import rsal.device.Subscription;
import rsal.python.PythonRequests.Heard;

/// The boards of its team that an agent in Python uses, or keeps as their master. On the agent's lane.
final class PythonBoards {
    private final AgentContext self;
    private final Heard heard;
    private final Map<Integer, Subscription> held;
    private final Map<String, TeamBoard> boards = new HashMap<>(); // by name

    /// @param held what Python may cancel, by number
    PythonBoards(AgentContext self, Heard heard, Map<Integer, Subscription> held) {
        this.self = self;
        this.heard = heard;
        this.held = held;
    }

    void perform(PythonRequests.Request asked) {
        switch (asked.verb()) {
            case "board" -> {
                int number = asked.number(1);
                boards.put(
                        asked.text(0), new TeamBoard(self, asked.text(0), event -> heard.hear(number, false, event)));
            }
            case "keepBoard" -> new BoardKeeper(self, asked.text(0), BoardKeeper.Limits.DEFAULT).begin();
            case "writeBoard" -> write(board(asked), PythonRequests.topic(asked.text(1)), asked);
            case "eraseBoard" -> board(asked).erase(PythonRequests.topic(asked.text(1)), asked.text(2));
            case "askBoard" -> ask(asked.number(3), board(asked), query(asked));
            case "watchBoard" -> watch(asked.number(3), board(asked), query(asked));
            default -> throw new IllegalArgumentException("RSAL knows no '%s'.".formatted(asked.verb()));
        }
    }

    private TeamBoard board(PythonRequests.Request asked) {
        return Optional.ofNullable(boards.get(asked.text(0))).orElseThrow();
    }

    private static <M> void write(TeamBoard board, Topic<M> topic, PythonRequests.Request asked) {
        M content = PythonRequests.content(topic, asked.argument(3));
        if (asked.argument(5) == null) {
            board.write(topic, asked.text(2), content, asked.seconds(4));
        } else {
            var place = (Point2d) FromWords.value(asked.argument(5), Point2d.class);
            board.write(topic, asked.text(2), content, place, asked.seconds(4));
        }
    }

    private static Query<?> query(PythonRequests.Request asked) {
        Map<?, ?> wanted = FromWords.map(asked.argument(2));
        Query<?> query = Query.of(PythonRequests.topic(asked.text(1))).newest(FromWords.integer(wanted.get("newest")));
        if (wanted.get("name") instanceof String name && !name.isEmpty()) {
            query = query.named(name);
        }
        if (wanted.get("author") instanceof String author && !author.isEmpty()) {
            query = query.by(author);
        }
        return wanted.get("near") == null
                ? query
                : query.within(FromWords.number(wanted.get("distance")), (Point2d)
                        FromWords.value(wanted.get("near"), Point2d.class));
    }

    private <M> void ask(int number, TeamBoard board, Query<M> query) {
        Consumer<ConversationResult<Found<M>>> onEnd = ending -> heard.hear(
                number, false, PythonConversations.words(ending, found -> words(found.notes(), found.left(), true)));
        board.ask(query, onEnd);
    }

    private <M> void watch(int number, TeamBoard board, Query<M> query) {
        var told = new Runnable() {
            private Optional<BoardWatch<M>> watch = Optional.empty();

            @Override
            public void run() {
                watch.ifPresent(of -> heard.hear(number, true, words(of.notes(), 0, of.isCurrent())));
            }
        };
        BoardWatch<M> watch = board.watch(query, told);
        told.watch = Optional.of(watch);
        held.put(number, watch);
    }

    private static <M> Map<String, Object> words(List<Note<M>> notes, int left, boolean current) {
        var words = new LinkedHashMap<String, Object>();
        words.put("notes", notes.stream().map(PythonBoards::words).toList());
        words.put("left", left);
        words.put("current", current);
        return words;
    }

    private static Map<String, Object> words(Note<?> note) {
        var words = new LinkedHashMap<String, Object>();
        words.put("name", note.name());
        words.put("content", note.content());
        words.put("author", note.author());
        words.put("written", note.written());
        words.put("fades", note.fades());
        words.put("place", note.mapFromPlace());
        return words;
    }
}
