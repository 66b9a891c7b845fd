package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.module.ModuleDescriptor;
import java.net.URI;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import rsal.testkit.architecture.ClassRules;

/// What the tests of each module try on its own classes, on those of all modules at once: that takes a few seconds,
/// not a few for each of thirty processes.
@EnabledIfSystemProperty(named = "rsal.test.whole", matches = "true", disabledReason = "each module's own tests try it")
class AllModulesTest extends ClassRules {
    /// Not on the class path of these tests.
    private static final List<String> ELSEWHERE =
            List.of("agents/jadex", "testing/bench-jadex", "testing/jmh", "apps/release");

    AllModulesTest() {
        super(homes());
    }

    @Test
    void noModuleIsForgotten() throws IOException {
        try (Stream<Path> sources =
                Files.find(Path.of("../.."), 6, (file, _) -> file.endsWith("src/main/java/module-info.java"))) {
            long written = sources.filter(
                            file -> ELSEWHERE.stream().noneMatch(folder -> file.startsWith(Path.of("../..", folder))))
                    .count();
            assertThat(homes()).hasSize((int) written);
        }
    }

    private static List<Path> homes() {
        try {
            return Collections.list(AllModulesTest.class.getClassLoader().getResources("module-info.class")).stream()
                    .filter(AllModulesTest::isOurs)
                    .map(AllModulesTest::home)
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static boolean isOurs(URL file) {
        try (InputStream in = file.openStream()) {
            return ModuleDescriptor.read(in).name().startsWith("rsal.");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// @param file in it, of a folder or of a jar
    private static Path home(URL file) {
        String address = file.toString();
        if (address.startsWith("jar:")) {
            return Path.of(URI.create(address.substring("jar:".length(), address.indexOf("!/"))));
        }
        return Path.of(URI.create(address)).getParent();
    }
}
