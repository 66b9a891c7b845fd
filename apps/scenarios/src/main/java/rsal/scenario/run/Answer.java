package rsal.scenario.run;

/// What became of an operator's command.
public sealed interface Answer {
    record Done() implements Answer {}

    /// Something was added.
    ///
    /// @param name of it
    record Added(String name) implements Answer {}

    record Able(Abilities abilities) implements Answer {}

    /// @param why a sentence for people
    record Refused(String why) implements Answer {}
}
