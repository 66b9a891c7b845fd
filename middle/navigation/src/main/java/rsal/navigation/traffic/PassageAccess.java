package rsal.navigation.traffic;

/// What keeps a robot from the passages that it wants.
enum PassageAccess {
    FREE,
    /// Not all who decide have answered.
    ASKED,
    /// Somebody else goes first.
    TAKEN
}
