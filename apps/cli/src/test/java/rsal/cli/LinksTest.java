package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/// Links of the documentation lead somewhere: to files that are there, and to headings that are in them.
class LinksTest {
    private static final Path TOP = Path.of("../..").toAbsolutePath().normalize();
    private static final Pattern CODE = Pattern.compile("(?ms)^```.*?^```$|`[^`\n]*`");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");

    static List<Path> pages() throws IOException {
        try (Stream<Path> docs = Files.walk(TOP.resolve("docs"));
                Stream<Path> scenarios = Files.walk(TOP.resolve("runs/scenarios/src/main/resources"))) {
            Stream<Path> others = Stream.of(
                            "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "agents/own/README.md")
                    .map(TOP::resolve);
            return Stream.of(docs, scenarios, others)
                    .flatMap(files -> files)
                    .filter(file -> file.toString().endsWith(".md") && !file.startsWith(TOP.resolve("docs/site")))
                    .map(TOP::relativize)
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void leadSomewhere(Path page) throws IOException {
        String prose = CODE.matcher(Files.readString(TOP.resolve(page))).replaceAll("code");
        List<String> dead = LINK.matcher(prose)
                .results()
                .map((MatchResult link) -> link.group(1))
                .filter(link -> !link.matches("(https?|mailto):.*"))
                .filter(link -> !leads(TOP.resolve(page), link))
                .toList();
        assertThat(dead).as("dead links of %s", page).isEmpty();
    }

    /// A place in quotes behind brackets is meant as a link, and shown as it stands there.
    @ParameterizedTest
    @MethodSource("pages")
    void areWrittenAsMarkdownHasThem(Path page) throws IOException {
        assertThat(Files.readString(TOP.resolve(page))).as(page.toString()).doesNotContainPattern("\\]'[#./\\w]");
    }

    private static boolean leads(Path from, String link) {
        String[] fileAndHeading = link.split("#", 2);
        Path file = fileAndHeading[0].isEmpty()
                ? from
                : from.resolveSibling(URLDecoder.decode(fileAndHeading[0], StandardCharsets.UTF_8));
        if (!Files.exists(file)) {
            return false;
        }
        return fileAndHeading.length == 1 || headings(file).contains(fileAndHeading[1]);
    }

    /// The places of a page's headings, as GitHub calls them.
    private static Set<String> headings(Path page) {
        try {
            var places = new HashSet<String>();
            String outside = Pattern.compile("(?ms)^```.*?^```$")
                    .matcher(Files.readString(page))
                    .replaceAll("");
            HEADING.matcher(outside).results().forEach(heading -> {
                String place = Markdown.anchor(heading.group(1));
                for (int i = 1; !places.add(place); i++) {
                    place = Markdown.anchor(heading.group(1)) + "-" + i;
                }
            });
            return places;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
