package rsal.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Bars.Bar;
import rsal.bench.measurement.Plot.Lines.Point;
import rsal.bench.measurement.Plot.Shares.Share;
import rsal.bench.measurement.Result;
import rsal.cli.terminal.Unreachable;
import tools.jackson.databind.json.JsonMapper;

class BenchPageTest {
    private static final BenchCommand.Machine MACHINE = new BenchCommand.Machine("25", "Linux", 2);

    @TempDir
    Path folder;

    @AfterEach
    void forget() {
        System.clearProperty("rsal.page");
    }

    @Test
    void carriesAllThatItNeeds() throws IOException {
        Path file = folder.resolve("page.html");
        page(file, "draw('</script>')")
                .write(
                        "navigation",
                        List.of(new Result("a.b<c>", 2.5, 1, 3, "ms", "less", Optional.of(4.5))),
                        List.of(
                                new Plot.Bars(
                                        "Bars & more", "world", "time [s]", List.of(new Bar("vfh", "</script>", 2))),
                                new Plot.Shares("Shares", "world", "", "share", List.of(new Share("nd", "w7", 0.75))),
                                new Plot.Lines("Lines", "time [s]", "error [m]", List.of(new Point("one", 0.5, 0.25)))),
                        MACHINE);
        assertThat(Files.readString(file))
                .contains(
                        "a.b&lt;c>",
                        "2.5",
                        "4.5",
                        "Bars &amp; more",
                        "\"time [s]\"",
                        "\"vfh\"",
                        "\"name\":\"<\\/script>\"")
                .contains("\"column\":\"w7\"", "\"row\":\"nd\"", "0.75")
                .contains("draw('<\\/script>')", "\"x\":0.5", "Java 25, Linux, 2 cores")
                .doesNotContain("src=", "href=");
    }

    @Test
    void timesThatAreFarApartHaveALogarithmicAxis() {
        String logarithmic = "\"scale\":{\"type\":\"log\"}";
        assertThat(specification(bars("time of the processor [ms]", 0.1, 109)))
                .contains(logarithmic, "\"type\":\"point\"");
        assertThat(specification(bars("time of the processor [ms]", 30, 109)))
                .doesNotContain(logarithmic)
                .contains("\"type\":\"bar\"");
        assertThat(specification(bars("time of the processor [ms]", 0, 109))).doesNotContain(logarithmic);
        assertThat(specification(bars("true distance to places [m]", 0.1, 109))).doesNotContain(logarithmic);
        assertThat(specification(new Plot.Lines(
                        "Lines",
                        "particles",
                        "an update [ms]",
                        List.of(new Point("a", 1, 0.05), new Point("a", 2, 3)))))
                .contains(logarithmic);
    }

    private static Plot bars(String y, double... values) {
        return new Plot.Bars(
                "Bars",
                "",
                y,
                Arrays.stream(values).mapToObj(v -> new Bar("s", "n" + v, v)).toList());
    }

    private static String specification(Plot plot) {
        return new JsonMapper().writeValueAsString(BenchPage.specification(plot));
    }

    @Test
    void itsTableScrollsByItself() throws IOException {
        Path file = folder.resolve("page.html");
        page(file, "").write("navigation", List.of(), List.of(), MACHINE);
        assertThat(Files.readString(file))
                .contains(".table { overflow-x: auto; }", "<div class=\"table\" tabindex=\"0\">\n<table>");
    }

    @Test
    void saysBeforeAnythingIsMeasuredThatItCantBeWritten() {
        assertThatExceptionOfType(Unreachable.class)
                .isThrownBy(() -> page(folder, ""))
                .withMessageContaining(folder.toString());
        assertThatExceptionOfType(Unreachable.class)
                .isThrownBy(() -> page(folder.resolve("no/such/folder.html"), ""))
                .withMessageContaining("folder.html");
    }

    @Test
    void saysWhatIsMissing() {
        System.setProperty("rsal.page", folder.resolve("nowhere").toString());
        assertThatExceptionOfType(Unreachable.class)
                .isThrownBy(() -> BenchPage.at(folder.resolve("page.html")))
                .withMessageContainingAll("plots.js", "doctor");
    }

    private BenchPage page(Path file, String script) throws IOException {
        Files.writeString(folder.resolve("plots.js"), script);
        System.setProperty("rsal.page", folder.toString());
        return BenchPage.at(file);
    }
}
