package rsal.metric;

import java.util.List;

/// A metric in a run. All calls on the run's thread. What it throws ends the run, with its words.
public interface Metric {
    /// An agent or the operator has said something. In conversations, what comes again because it may have been
    /// lost is not told again.
    ///
    /// @param sender name of the agent, or `operator`
    /// @param content of the message; in conversations by FIPA's protocols, what they are about
    default void onMessage(String sender, Object content) {}

    /// A step of the run is over.
    default void onStep() {}

    /// What a quantity is now. Asked after each step in which a condition or metric needs it.
    ///
    /// @param quantity a word of [MetricType#quantities]
    /// @param names as [QuantityType#names] declares them; empty for one without, or whose names are left out
    /// @return NaN while it is not known: then no comparison holds
    default double value(String quantity, List<String> names) {
        throw new IllegalArgumentException("There is no quantity '%s'.".formatted(quantity));
    }

    /// Whether a quantity that counts ([QuantityType#countsAll]) counts all of them.
    ///
    /// @param all how many robots of the role, or things of the group, there are and will be
    default boolean holdsForAll(String quantity, String name, int all) {
        return value(quantity, List.of(name)) >= all;
    }
}
