package rsal.jade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/// JADE's windows on a screen that nobody sees.
class JadeWindowsIT {
    private static final String SCREEN = "Xvfb";

    @Test
    void theyShowTheAgentsOfARun() throws Exception {
        assumeTrue(isThere(SCREEN), "JADE's windows need a screen (Xvfb), and there is none. Maybe install xvfb.");
        Process screen = new ProcessBuilder(
                        SCREEN, "-displayfd", "1", "-screen", "0", "1280x1024x24", "-nolisten", "tcp")
                .redirectError(Redirect.DISCARD)
                .start();
        try (BufferedReader said = screen.inputReader()) {
            assertThat(windowsOn(said.readLine()))
                    .hasSize(2)
                    .anySatisfy(rma -> assertThat(rma)
                            .startsWith("rma@")
                            .contains("JADE Remote Agent Management GUI: ", "amy@", "bob@"))
                    .anySatisfy(sniffer ->
                            assertThat(sniffer).startsWith("sniffer@").contains("Sniffer Agent: ", "amy@", "bob@"));
        } finally {
            screen.destroy();
        }
    }

    private static boolean isThere(String program) {
        return Arrays.stream(System.getenv().getOrDefault("PATH", "").split(":", -1))
                .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
    }

    /// What [JadeWindows] says.
    ///
    /// @param display its number
    private static List<String> windowsOn(String display) throws IOException, InterruptedException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        var builder = new ProcessBuilder(
                java, "-Xmx256m", "-cp", System.getProperty("java.class.path"), JadeWindows.class.getName());
        builder.environment().put("DISPLAY", ":" + display);
        Process program = builder.redirectError(Redirect.INHERIT).start();
        try (BufferedReader said = program.inputReader()) {
            assertThat(program.waitFor(100, TimeUnit.SECONDS)).as("it ends").isTrue();
            assertThat(program.exitValue()).as("its code").isZero();
            return said.readAllLines();
        } finally {
            program.destroyForcibly();
        }
    }
}
