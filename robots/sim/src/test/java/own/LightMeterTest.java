package own;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/// The kind of device of `docs/how-to/own-device.md`. What it does is tried with all others.
class LightMeterTest {
    private static final Path HERE = Path.of("src/test/java/own");
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```java\\n(.*?)^```");
    private static final Pattern NAME = Pattern.compile("public (?:final class|record|interface) (\\w+)");

    @Test
    void thePageQuotesItAsItIs() throws IOException {
        var blocks = BLOCK.matcher(Files.readString(Path.of("../../docs/how-to/own-device.md")));
        int quoted = 0;
        while (blocks.find()) {
            String block = blocks.group(1);
            var name = NAME.matcher(block);
            assertThat(name.find()).as(block).isTrue();
            assertThat(block).isEqualTo(Files.readString(HERE.resolve(name.group(1) + ".java")));
            quoted++;
        }
        assertThat(quoted).isEqualTo(4);
    }
}
