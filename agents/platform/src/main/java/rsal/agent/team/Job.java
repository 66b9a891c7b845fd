package rsal.agent.team;

/// Something that one member of a team can do as a whole. Immutable.
public interface Job {
    /// Unique among the jobs of a team, for people too (`visit the lab`).
    String name();
}
