package rsal.engine.report;

import java.time.Duration;
import java.util.List;
import rsal.agent.bdi.Mind;

/// Something else that an agent does, believes or wants than before.
///
/// @param time since the run's start
/// @param name of the belief or goal; empty of what it does
/// @param words what it is from then on; empty when there is none any more
public record MindChange(Duration time, Kind kind, String name, String words) {
    public enum Kind {
        DOES,
        BELIEVES,
        WANTS
    }

    /// What somebody believes and wants that is other than when it was looked at before.
    ///
    /// @param time of the later look
    public static List<MindChange> between(Mind.View before, Mind.View after, Duration time) {
        return MindWords.of(before.beliefs(), before.goals())
                .changesTo(MindWords.of(after.beliefs(), after.goals()), time);
    }
}
