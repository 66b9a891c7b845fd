package rsal.agent.board;

/// What becomes of a board that an agent uses.
public sealed interface BoardEvent {
    /// There is a master that keeps it, and everything of this agent's that has not faded will be written there.
    ///
    /// @param keeper name of the master
    record Kept(String keeper) implements BoardEvent {}

    /// The master has ended. When another keeps the board already, that is told next.
    record Gone(String keeper) implements BoardEvent {}

    /// Nothing is heard of the master; it is asked again and again.
    record Silent(String keeper, String why) implements BoardEvent {}

    /// The master is heard again.
    record Heard(String keeper) implements BoardEvent {}

    /// The master, or this agent's own end of the board, takes something not.
    ///
    /// @param what a note's topic and name, or what was to be watched
    record Refused(String what, String why) implements BoardEvent {}
}
