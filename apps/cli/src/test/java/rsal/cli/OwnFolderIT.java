package rsal.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/// Does what how-tos say that have people write into `agents/own`.
class OwnFolderIT {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"own-device", "another-robot-system", "another-world-format"})
    void itsCommandsShowWhatItSays(String guide) throws Exception {
        String page = Files.readString(Path.of("../../docs/how-to", guide + ".md"));
        OwnFolder own = OwnFolder.of(page, folder);
        TutorialIT.follow(page, new Rsal(folder, own.classes().toString()));
    }
}
