package rsal.metric;

/// What a name in the parentheses of a quantity means.
public enum NameKind {
    /// A role of robots.
    ROLE,
    /// A place of the scenario.
    PLACE,
    /// A group of things that are to be brought somewhere: one with a `depot`.
    THINGS_TO_COLLECT,
    /// A group of things that robots are to get to: one with a `reach`.
    THINGS_TO_REACH,
    /// A topic of messages: any name, in quotes when it is no word.
    TOPIC,
    /// A value that agents publish: any name, in quotes when it is no word.
    PUBLISHED
}
