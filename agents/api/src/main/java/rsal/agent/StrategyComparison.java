package rsal.agent;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.SequencedMap;

/// Compares strategies of teams on a problem in a file, with ideal robots and without a run. Found by
/// [java.util.ServiceLoader] and named by its key (`rsal patrol`).
public interface StrategyComparison {
    /// What it is called: `patrol`.
    String key();

    /// The keys of the strategies that it can compare, in ascending order.
    List<String> strategies();

    /// The unit of all means: `s`.
    String unit();

    /// Means over several runs, for each number of robots and each strategy.
    ///
    /// @param text of the file
    /// @param strategies some of [#strategies]
    /// @throws IllegalArgumentException with a sentence when the text is no such problem
    List<Row> compare(String text, List<String> strategies, Team team);

    /// @param robots how many robots a team has; a table for each
    /// @param speed of the robots [m/s]
    /// @param stop time that a robot loses at each place [s]
    /// @param seeds number of runs
    /// @param time of each run, of which the first quarter does not count [s]
    record Team(List<Integer> robots, double speed, double stop, int seeds, double time) {
        public Team {
            robots = List.copyOf(robots);
        }
    }

    /// @param robots of the team
    /// @param strategy its key
    /// @param means by names of metrics, in the order to be shown; the same names in each row
    record Row(int robots, String strategy, SequencedMap<String, Double> means) {
        public Row {
            means = Collections.unmodifiableSequencedMap(new LinkedHashMap<>(means));
        }
    }
}
