package rsal.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/// Does what the how-to about a robot system of one's own says.
class OwnRobotSystemIT {
    @TempDir
    Path folder;

    @Test
    void itsCommandsShowWhatItSays() throws Exception {
        String page = Files.readString(Path.of("../../docs/how-to/another-robot-system.md"));
        OwnFolder own = OwnFolder.of(page, folder);
        TutorialIT.follow(page, new Rsal(folder, own.classes().toString()));
    }
}
