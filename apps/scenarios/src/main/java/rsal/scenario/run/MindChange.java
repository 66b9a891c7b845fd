package rsal.scenario.run;

import java.time.Duration;

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
}
