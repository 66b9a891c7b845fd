package rsal.scenario.run;

import java.util.List;
import java.util.Optional;
import rsal.agent.Message;

/// Counts what agents say and hear. Who heard what is recorded, and part of the event hash, where communication is
/// limited: else all hear all, and a count is enough. All calls on the run's thread.
final class Traffic {
    private final Journal journal;
    private final Observer observer;
    private final Optional<Hearings> hearings;

    Traffic(Journal journal, Observer observer, boolean isLimited) {
        this.journal = journal;
        this.observer = observer;
        this.hearings = isLimited ? Optional.of(new Hearings()) : Optional.empty();
    }

    void said() {
        observer.messageSaid();
    }

    void heard(Message<?> message, String listener) {
        observer.messageHeard();
        if (hearings.isPresent()) {
            String topic = message.topic().name();
            journal.hash("heard", message.sender(), topic, listener);
            hearings.get().heard(message.sender(), listener, topic);
        }
    }

    void lost(Message<?> message, String listener) {
        observer.messageLost();
        String topic = message.topic().name();
        journal.hash("lost", message.sender(), topic, listener);
        hearings.ifPresent(all -> all.lost(message.sender(), listener, topic));
    }

    /// Who heard what so far; nothing where communication is not limited.
    List<Hearing> hearings() {
        return hearings.map(Hearings::all).orElse(List.of());
    }
}
