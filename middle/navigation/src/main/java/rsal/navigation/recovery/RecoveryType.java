package rsal.navigation.recovery;

import java.time.Duration;
import java.util.random.RandomGenerator;
import rsal.data.Footprint;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.DriveLimits;
import rsal.settings.Arguments;
import rsal.settings.Plugin;
import rsal.time.Scheduler;

/// A kind of recoveries: what a navigator does when the robot makes no progress. Found by
/// [java.util.ServiceLoader], or a Java file that a scenario names: `navigator: {recoveries: [wait, Mine.java]}`.
public interface RecoveryType extends Plugin {
    /// What a recovery drives, and by what.
    ///
    /// @param lookahead how far ahead on the path the robot aims [m]
    /// @param reaction how long the robot takes to do what it is told, at most [s]
    /// @param speed for backing up [m/s]
    /// @param time for backing up, at most
    /// @param controller of the robot; keeps what it did last
    /// @param scheduler for work that takes long ([Scheduler#compute])
    record Driven(
            Footprint footprint,
            DriveLimits limits,
            double lookahead,
            double reaction,
            double speed,
            Duration time,
            Controller controller,
            Scheduler scheduler,
            RandomGenerator random) {
        /// A random part of a time: two robots in each other's way should not do the same.
        Duration partOf(Duration atMost) {
            return Duration.ofMillis((long) (atMost.toMillis() * random.nextDouble(0.3, 1)));
        }
    }

    /// One for each goal.
    ///
    /// @param arguments for [#parameters]
    Recovery create(Arguments arguments, Driven driven);
}
