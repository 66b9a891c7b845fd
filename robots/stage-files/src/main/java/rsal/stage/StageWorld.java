package rsal.stage;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// A world of Stage: what is in it and where, before anything moves.
///
/// @param title for people
/// @param step simulated time between two states (`interval_sim`)
/// @param resolution side of the cells that Stage would see the world in [m]; here shapes are exact
/// @param quitTime when the run ends
/// @param models at the top, each with those that stand on it or are part of it
/// @param warnings what of the files has no effect here, each place once, in the order it was found
public record StageWorld(
        String title,
        Duration step,
        double resolution,
        Optional<Duration> quitTime,
        List<StageModel> models,
        List<Problem> warnings) {

    public StageWorld {
        models = List.copyOf(models);
        warnings = List.copyOf(warnings);
    }

    /// Reads a `.world` file and all that it includes.
    ///
    /// @param path as a person writes it; messages call it so
    /// @throws InvalidSettings with all errors that could be found, each with its file and line
    public static StageWorld read(String path, WorldFiles files) {
        var findings = new WorldProblems();
        WorldFile file = WorldFile.read(path, files, findings);
        return new StageModelReader(path, file, files, findings).world();
    }

    /// Every model, parents before their children.
    public void forEach(Consumer<? super StageModel> action) {
        models.forEach(model -> model.forEach(action));
    }
}
