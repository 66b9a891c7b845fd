package rsal.engine.report;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import rsal.agent.bdi.Mind;

/// Sees all of a run: each event, each message, and now and then how everything stands. Called on the run's thread, in
/// the order in which it happens; it changes nothing, and what it takes long for holds the run up.
///
/// Hashes are those over all that has happened so far, the first 16 digits of what [RunResult#eventHash] has 64 of.
/// One that throws breaks the run.
public interface RunObserver {
    /// All of them at once, each as often as the one that wants to see most.
    static RunObserver all(List<RunObserver> witnesses) {
        return witnesses.size() == 1 ? witnesses.getFirst() : new RunObservers(witnesses);
    }

    /// How often it is shown how everything stands [s of the run], and at the end.
    Duration period();

    /// Whether it looks now; else it is not shown how everything stands, which costs time.
    default boolean looks() {
        return true;
    }

    /// How everything stands.
    void sees(Snapshot now, String hash);

    /// What agents believe and want; about once a second, those alone that show it.
    void looksInto(Duration time, Map<String, Mind.View> minds);

    /// An event; each is told, also where a run has more than it keeps.
    void happened(RunEvent event, String hash);

    /// A message.
    ///
    /// @param content what was said; of an act of a conversation, what that is about. Agents must not change it
    void heard(SentMessage message, Object content);
}
