package rsal.agent.board;

import java.util.List;

/// What a board knew.
///
/// @param notes the newest first
/// @param left how many more it had than were asked for
public record Found<M>(List<Note<M>> notes, int left) {
    public Found {
        notes = List.copyOf(notes);
    }
}
