package rsal.server;

import java.time.Duration;

/// All that viewers are shown of one moment of a run. Its parts are shared with other moments, and never changed.
///
/// @param time since the run's start
/// @param details [Messages.Details] as JSON
/// @param frame as [FrameEncoder] writes it
record Moment(Duration time, ObjectRegistry things, String details, byte[] frame) {}
