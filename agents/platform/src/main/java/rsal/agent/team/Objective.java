package rsal.agent.team;

/// What a division of jobs makes least.
public enum Objective {
    /// The sum of all costs: least energy.
    SUM,
    /// The cost of the one that has most to do: least time.
    LONGEST,
    /// Nothing: a member that is free gets the job that has waited longest. To compare with.
    NONE
}
