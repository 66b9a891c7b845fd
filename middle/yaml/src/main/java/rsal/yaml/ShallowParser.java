package rsal.yaml;

import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.parser.Parser;
import rsal.settings.InvalidSettings;

/// Passes a parser's events on until they nest too deeply: what is built of them is built by recursion, which would
/// otherwise end in a stack overflow.
final class ShallowParser implements Parser {
    private final Parser parser;
    private final String file;
    private final int most;
    private int depth;

    /// @param file what to call it in messages
    ShallowParser(Parser parser, String file, int most) {
        this.parser = parser;
        this.file = file;
        this.most = most;
    }

    @Override
    public boolean checkEvent(Event.ID id) {
        return parser.checkEvent(id);
    }

    @Override
    public Event peekEvent() {
        return parser.peekEvent();
    }

    @Override
    public boolean hasNext() {
        return parser.hasNext();
    }

    @Override
    public Event next() {
        Event event = parser.next();
        depth += switch (event.getEventId()) {
            case SequenceStart, MappingStart -> 1;
            case SequenceEnd, MappingEnd -> -1;
            default -> 0;
        };
        if (depth > most) {
            throw new InvalidSettings(
                    Yaml.location(file, event.getStartMark().orElse(null)),
                    "Settings are nested deeper than %d.".formatted(most),
                    "Maybe a bracket is not closed.");
        }
        return event;
    }
}
