package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import rsal.engine.OperatorCommands;
import rsal.server.message.Messages;

/// Keeps the page's types in step with what the server sends. `-Drsal.update=true` writes them anew.
class PageTypesTest {
    private static final Path TYPES = Path.of("../web/src/api/messages.ts");

    @Test
    void pageKnowsTheMessagesAsTheyAre() throws IOException {
        String types = TypeScript.of(Messages.class) + TypeScript.of(OperatorCommands.ALL);
        if (Boolean.getBoolean("rsal.update")) {
            Files.writeString(TYPES, types);
        }
        assertThat(Files.readString(TYPES))
                .as("%s; mend with: ./mvnw -pl apps/server -am test -Dtest=PageTypesTest -Drsal.update=true", TYPES)
                .isEqualTo(types);
    }
}
