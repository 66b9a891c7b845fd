package rsal.navigation.rooms;

/// What a part of a floor is for, as far as its shape tells.
public enum RegionKind {
    /// Where people and robots stay.
    ROOM,
    /// What leads to rooms: narrow, long, with several gates.
    CORRIDOR,
    /// Too small to stay in.
    CLOSET
}
