package rsal.server.history;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import rsal.engine.report.MindChange;
import rsal.engine.report.ReceivedMessage;
import rsal.engine.report.RunEvent;
import rsal.engine.report.SentMessage;
import rsal.engine.report.SpeechAct;

/// What events of a run tell of an agent's past: what it did, what was said to it by name, and what it talked about.
/// Whom it reached what is said to all is no event. Of each kind it has the last [#MOST_OF_A_KIND].
public final class AgentPast {
    private static final Set<String> DOINGS = Set.of("agent", "fault", "print"); // kinds of events
    private static final int MOST_OF_A_KIND = 100; // changes, or messages

    private final String agent;
    private final List<RunEvent> happened;

    /// @param events of the run, oldest first; also later ones
    public AgentPast(String agent, Duration until, List<RunEvent> events) {
        this.agent = agent;
        this.happened = events.stream()
                .takeWhile(event -> event.time().compareTo(until) <= 0)
                .toList();
    }

    /// What it did, believed and wanted last, oldest first.
    ///
    /// @param minded what it believed and wanted
    public List<MindChange> history(List<MindChange> minded) {
        Stream<MindChange> done = happened.stream()
                .filter(event -> event.subject().equals(agent) && DOINGS.contains(event.kind()))
                .map(event -> new MindChange(event.time(), MindChange.Kind.DOES, "", event.text()));
        return last(Stream.concat(done, minded.stream())
                .sorted(Comparator.comparing(MindChange::time))
                .toList());
    }

    public List<ReceivedMessage> mail() {
        return last(said().filter(said -> said.to().equals(agent))
                .map(said -> new ReceivedMessage(said.time(), said.from(), false, said.topic(), words(said)))
                .toList());
    }

    /// What was said again, as nobody answered, is not among the events.
    public List<SpeechAct> talks() {
        return last(said().filter(said -> !said.conversation().isEmpty()
                        && (said.to().equals(agent) || said.from().equals(agent)))
                .map(said -> new SpeechAct(
                        said.time(),
                        said.from(),
                        said.to(),
                        said.conversation(),
                        said.protocol(),
                        said.act(),
                        about(said),
                        1))
                .toList());
    }

    /// What is said of a conversation begins with its partner and the act, which are told beside it.
    private static String about(SentMessage said) {
        String words = words(said);
        return words.startsWith(said.act())
                ? words.substring(said.act().length()).replaceFirst("^: ", "")
                : words;
    }

    private static String words(SentMessage said) {
        String partner = said.to() + ", ";
        return said.words().startsWith(partner) ? said.words().substring(partner.length()) : said.words();
    }

    private Stream<SentMessage> said() {
        return happened.stream().flatMap(event -> event.said().stream());
    }

    private static <T> List<T> last(List<T> all) {
        return all.subList(Math.max(0, all.size() - MOST_OF_A_KIND), all.size());
    }
}
