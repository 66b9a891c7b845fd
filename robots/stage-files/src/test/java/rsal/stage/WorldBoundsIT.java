package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import rsal.testkit.LongTest;
import rsal.testkit.Rounds;

/// Too much of anything is refused, quickly and in words.
class WorldBoundsIT {
    @Test
    void deepNesting() {
        refused("model ( ".repeat(100_000), "'model' is more than 64 deep in others.");
        refused("model ( ".repeat(5000) + ") ".repeat(5000), "'model' is more than 64 deep in others.");
        refused("define a ".repeat(100_000), "'define' is incomplete.");
        refused("( ".repeat(100_000), "Here a name was expected, not '('.");
        refused("a [ ".repeat(100_000), "'a' can't stand in a tuple.");
    }

    @Test
    void deepInheritance() {
        var text = new StringBuilder("define a0 model ( )\n");
        for (int i = 1; i < 1000; i++) {
            text.append("define a%d a%d ( mass %d )\n".formatted(i, i - 1, i));
        }
        refused(text.toString(), "'a65' builds upon more than 64 macros.");
    }

    @Test
    void deepMacros() {
        var text = new StringBuilder("define a0 model ( )\n");
        for (int i = 1; i < 1000; i++) {
            text.append("define a%d model ( a%d ( ) )\n".formatted(i, i - 1));
        }
        refused(text + "a999 ( )", "deep in macros.");
    }

    @Test
    void aBombOfMacros() {
        var text = new StringBuilder("define a0 model ( )\n");
        for (int i = 1; i < 40; i++) {
            text.append("define a%d model ( %s )\n".formatted(i, ("a" + (i - 1) + " ( ) ").repeat(10)));
        }
        refused(text + "a39 ( )", "would make more than 2000000 entities.");
        refused(text + "a6 ( )", "would make more than 2000000 entities.", "The world has more than 250000 models.");
        refused(text + "a5 ( )\n".repeat(100), "more than");
    }

    @Test
    @LongTest
    void aBombOfBlocks() {
        var points = new StringBuilder("define b block ( points 1000 ");
        for (int i = 0; i < 1000; i++) {
            points.append("point[%d] [%d %d] ".formatted(i, i, i * i));
        }
        String text = points + ")\ndefine m model ( " + "b ( ) ".repeat(1000) + ")\n" + "m ( mass 1 )\n".repeat(1000);
        refused(text, "The world's blocks have more than 4000000 points.");
    }

    @Test
    void aBombOfIncludes() {
        var worlds = Worlds.of("include \"0.inc\"");
        for (int i = 0; i < 100; i++) {
            worlds.and(i + ".inc", "include \"%d.inc\"\ninclude \"%d.inc\"\n".formatted(i + 1, i + 1));
        }
        refused(worlds, "Files are included 33 deep or more than 1000 times.");
        var wide = Worlds.of("include \"a.inc\"\n".repeat(2000)).and("a.inc", "model ( )");
        refused(wide, "Files are included 1 deep or more than 1000 times.");
    }

    @Test
    void tooManyTokens() {
        refused("model ( ) ".repeat(700_000), "The world has more than 2000000 words, numbers and brackets.");
    }

    @Test
    void tooManyModels() {
        refused("define a model ( )\n" + "a ( )\n".repeat(250_001), "The world has more than 250000 models.");
    }

    @Test
    void tenThousandRobotsAreNotTooMany() {
        var text = new StringBuilder("define eye sensor ( range [0 2] )\ndefine bot position ( ranger ( ");
        text.append("eye ( pose [0 0 0 30] ) ".repeat(12))
                .append(") model ( block ( points 3 point[0] [0 0] ")
                .append("point[1] [1 0] point[2] [0 1] ) ) )\n");
        for (int i = 0; i < 10_000; i++) {
            text.append("bot ( name \"r%d\" pose [%d %d 0 0] )\n".formatted(i, i % 100, i / 100));
        }
        var world = Worlds.of(text.toString()).read();
        assertThat(world.models()).hasSize(10_000);
        assertThat(world.models().getFirst().traits())
                .isSameAs(world.models().getLast().traits());
    }

    @LongTest
    @Test
    void endlessGuesses() {
        var text = new StringBuilder();
        for (int i = 0; i < Rounds.of(8_000, 30_000); i++) {
            text.append("define macro%d model ( color \"colour%d\" property%d 1 )\n".formatted(i, i, i));
            text.append("macro%d ( )\nteleport%d ( )\n".formatted(i, i));
        }
        text.append("define %s model ( )\n%s ( )".formatted("x".repeat(500_000), "y".repeat(500_000)));
        List<String> warnings = Assertions.assertTimeoutPreemptively(
                Duration.ofSeconds(60), () -> Worlds.of(text.toString()).warnings());
        assertThat(warnings).hasSize(501);
    }

    @Test
    void longNamesAreCutInMessages() {
        assertThat(Worlds.of("model ( %s )".formatted("x".repeat(100_000)))
                        .errors()
                        .getFirst())
                .hasSizeLessThan(200);
    }

    private static void refused(String text, String... messages) {
        refused(Worlds.of(text), messages);
    }

    private static void refused(Worlds worlds, String... messages) {
        var errors = Assertions.assertTimeoutPreemptively(Duration.ofSeconds(60), worlds::errors);
        assertThat(errors).isNotEmpty();
        assertThat(messages)
                .anySatisfy(message -> assertThat(String.join("\n", errors)).contains(message));
    }
}
