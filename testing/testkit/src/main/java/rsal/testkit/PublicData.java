package rsal.testkit;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;

/// Public data sets, which are no part of the project: they lie in `shared/data` beside it, or beside one of the
/// folders it lies in. Tests that need them skip where they are not.
public final class PublicData {
    private PublicData() {}

    /// @param path within the data (`logs/aces-corrected.log.gz`)
    public static Path file(String path) {
        for (Path at = Path.of("").toAbsolutePath(); at != null; at = at.getParent()) {
            Path file = at.resolve("shared/data").resolve(path);
            if (Files.exists(file)) {
                return file;
            }
        }
        return Assumptions.abort("There is no 'shared/data/%s' beside the project.".formatted(path));
    }
}
