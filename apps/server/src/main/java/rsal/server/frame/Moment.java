package rsal.server.frame;

import java.time.Duration;

/// All that viewers are shown of one moment of a run. Its parts are shared with other moments, and never
/// changed.
///
/// @param time since the run's start
/// @param details [rsal.server.message.Messages.Details] as JSON
/// @param frame as [FrameEncoder] writes it
public record Moment(Duration time, ObjectRegistry things, String details, byte[] frame) {}
