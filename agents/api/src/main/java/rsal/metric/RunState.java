package rsal.metric;

import java.util.List;
import java.util.Optional;
import rsal.data.Walls;

/// A run as a metric sees it: true poses, whatever agents believe. All calls on the run's thread.
public interface RunState {
    /// Since the start of the run [s].
    double time();

    /// Robots that are in the run now, in the order in which they came.
    List<RobotState> robots();

    /// A robot that is or was in the run, where it is or was last.
    Optional<RobotState> robot(String id);

    /// Things in the simulated world; none without one.
    List<ThingState> things();

    /// Of the scenario's map.
    Walls walls();

    /// Notes a value of a signal of the whole run.
    void sample(SignalType signal, double value);

    /// Notes a value of a signal of one robot.
    ///
    /// @param robot its id; of one that is not in the run, nothing is noted
    void sample(SignalType signal, String robot, double value);

    /// Tells people of something. It is part of the run's event hash.
    ///
    /// @param kind a word by which people choose: `caught`
    /// @param subject id of a robot or name of a thing
    /// @param text goes on from the subject: `is caught`
    void event(String kind, String subject, String text);
}
