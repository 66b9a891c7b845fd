package rsal.stage.playercfg;

import java.util.List;
import rsal.stage.Dialect;
import rsal.stage.WorldFile;
import rsal.stage.WorldFiles;
import rsal.stage.WorldProblems;

/// A configuration file of a Player server, as it is written.
///
/// @param path as a person writes it
/// @param meters in a unit of length
/// @param radians in a unit of angles
/// @param drivers in the order of the file, in which they start
public record PlayerConfig(String path, double meters, double radians, List<Driver> drivers) {
    public PlayerConfig {
        drivers = List.copyOf(drivers);
    }

    /// Reads a file and all that it includes, which is looked for beside it.
    ///
    /// @param findings takes errors that leave something to read, and warnings
    /// @throws rsal.settings.InvalidSettings when there is no such file, or too much of anything
    public static PlayerConfig read(String path, WorldFiles files, WorldProblems findings) {
        WorldFile file = WorldFile.read(path, files, findings, Dialect.PLAYER);
        return new ConfigReader(path, file, findings).config();
    }
}
