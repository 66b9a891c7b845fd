package rsal.agents.patrol;

import java.util.List;
import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;

/// What a robot that patrols does, once a second. Places have their numbers in [PatrolOrder]; -1 is none.
///
/// @param robot its id
/// @param patrols false while it does something else, as charging
/// @param last the place where it was last, or to which it is nearest
/// @param next the place where it goes
/// @param remaining time until it arrives there, about [s]
/// @param note what its strategy wants others to know ([rsal.agents.patrol.strategy.PatrolStrategy#note])
public record PatrolReport(String robot, boolean patrols, int last, int next, double remaining, List<Integer> note)
        implements MessageContent {
    public static final Topic<PatrolReport> TOPIC = new Topic<>("patrol-report", PatrolReport.class);

    /// Largest number of numbers in a note.
    public static final int LONGEST_NOTE = 4000;

    public PatrolReport {
        MessageCheck.given("robot", robot);
        note = List.copyOf(note);
        if (!(remaining >= 0) || Double.isInfinite(remaining)) {
            throw new IllegalArgumentException("A robot arrives in at least 0 s, not '%s'.".formatted(remaining));
        }
        if (note.size() > LONGEST_NOTE) {
            throw new IllegalArgumentException(
                    "A note has at most %d numbers, not %d.".formatted(LONGEST_NOTE, note.size()));
        }
    }

    @Override
    public String words() {
        return patrols ? "%s patrols".formatted(robot) : "%s does not patrol".formatted(robot);
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
