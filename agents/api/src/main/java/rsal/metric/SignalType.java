package rsal.metric;

/// What there are samples of, as metrics write it: `poseError`, `idleness`. They take the mean, a percentile,
/// … of all samples.
///
/// @param word letters, digits, `_` and `-`, a letter first
/// @param unit as `m`; empty for a number without one
/// @param description for people, in a few words
/// @param isOfRobots whether each sample is of a robot, so that metrics can ask for one role or for each robot
public record SignalType(String word, String unit, String description, boolean isOfRobots) {
    public SignalType {
        QuantityType.checkWord(word);
    }

    /// One of the whole run.
    public static SignalType ofRun(String word, String unit, String description) {
        return new SignalType(word, unit, description, false);
    }

    /// One whose samples are of robots.
    public static SignalType ofRobots(String word, String unit, String description) {
        return new SignalType(word, unit, description, true);
    }
}
