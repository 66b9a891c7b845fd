package rsal.server.sweep;

import java.nio.file.Path;

/// Where sweeps that are begun in the page are kept, each in a folder of its own.
///
/// @param folder made when the first begins
/// @param program its name and version, to be noted with them
public record SweepHome(Path folder, String program) {}
