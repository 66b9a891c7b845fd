package rsal.server.sweep;

import java.nio.file.Path;

/// Folder for sweeps that are started in the page, each in its own folder.
///
/// @param folder made when the first begins
/// @param program its name and version, to be noted with them
public record SweepHome(Path folder, String program) {}
