package rsal.navigation.device;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.data.Twist2d;
import rsal.navigation.recovery.Recovery;
import rsal.navigation.recovery.Recovery.Situation;

/// The recoveries of one goal in their order, of which one at most runs.
final class RecoveryList {
    private final List<Named> all;
    private final Map<String, Integer> counts = new LinkedHashMap<>();
    private @Nullable Recovery running;
    private int place; // of the running one

    /// @param key what people call its kind
    record Named(String key, Recovery recovery) {}

    RecoveryList(List<Named> all) {
        this.all = List.copyOf(all);
    }

    /// Goes on with what runs for a former goal, unless that leads there.
    void succeed(RecoveryList old) {
        if (old.running != null && !old.running.followsOwnPath()) {
            running = old.running;
            place = old.place;
        }
    }

    boolean isRunning() {
        return running != null;
    }

    /// Whether the robot follows a path that its controller does not know.
    boolean followsOwnPath() {
        return running != null && running.followsOwnPath();
    }

    boolean isAnyDue(Situation situation) {
        for (Named named : all) { // ten times a second for each robot: no stream
            if (named.recovery().isDue(situation)) {
                return true;
            }
        }
        return false;
    }

    /// Begins the first that is due; nothing when none is.
    void begin(Situation situation) {
        begin(0, situation);
    }

    private void begin(int from, Situation situation) {
        running = null;
        for (int i = from; i < all.size(); i++) {
            Named named = all.get(i);
            if (named.recovery().isDue(situation)) {
                running = named.recovery();
                place = i;
                counts.merge(named.key(), 1, Integer::sum);
                running.begin(situation);
                return;
            }
        }
    }

    /// Looks whether what runs is over. After one that failed, the next one that is due begins.
    ///
    /// @return whether now none runs any more
    boolean endsNow(Situation situation) {
        if (running == null) {
            return false;
        }
        switch (running.state(situation)) {
            case RUNNING -> {}
            case DONE -> running = null;
            case FAILED -> begin(place + 1, situation);
        }
        return running == null;
    }

    /// What the one that runs commands.
    Twist2d command(Situation situation) {
        return running == null ? Twist2d.STOP : running.command(situation);
    }

    /// How often each began, by its key, in the order of their first time.
    Map<String, Integer> counts() {
        return counts;
    }
}
