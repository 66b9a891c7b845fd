package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.settings.Location;

/// How world files are written.
class WorldFileTest {
    @Test
    void aWorldIsPropertiesAndModels() {
        var world = Worlds.of("""
                # a comment ( [ " that means nothing
                name "Two carts"   # and another
                resolution 0.05
                interval_sim 50
                quit_time 600
                model ( name "left" ) model ( name "right" )
                """).read();
        assertThat(world.title()).isEqualTo("Two carts");
        assertThat(world.resolution()).isEqualTo(0.05);
        assertThat(world.step()).hasMillis(50);
        assertThat(world.quitTime()).hasValueSatisfying(time -> assertThat(time).hasSeconds(600));
        assertThat(world.models()).extracting(StageModel::name).containsExactly("left", "right");
        assertThat(world.warnings()).isEmpty();
    }

    @Test
    void anEmptyFileIsAnEmptyWorld() {
        var world = Worlds.of("").read();
        assertThat(world.models()).isEmpty();
        assertThat(world.title()).isEqualTo("test.world");
        assertThat(world.step()).hasMillis(100);
        assertThat(world.resolution()).isEqualTo(0.02);
        assertThat(world.quitTime()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", "\r"})
    void linesMayEndAsOnAnySystem(String end) {
        var world = Worlds.of(String.join(end, "# two models", "model", "(", "name \"a\"", ")", "model ( name \"b\" )"))
                .read();
        assertThat(world.models()).extracting(StageModel::name).containsExactly("a", "b");
        assertThat(world.models())
                .extracting(StageModel::location)
                .containsExactly(new Location("test.world", 2, 1), new Location("test.world", 6, 1));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "pose [1 -2 0.5 90]",
                "pose [1.0 -2. .5 +90]",
                "pose [1e0 -20e-1 0.05E+1 9e1]",
                "pose[1 -2 0.5 90]",
                "pose [ 1 -2\n 0.5 # height\n 90 ]",
                "pose\n[1 -2 0.5 90]",
                "pose [1 -2 0.5 90 7 8]",
                "pose [\"1\" \"-2\" 0.5 90]",
                "pose [0 0 0 0] pose [1 -2 0.5 90]"
            })
    void numbersAndTuplesAreReadLeniently(String pose) {
        Placement placement = Worlds.of("model ( %s )".formatted(pose)).model().worldFromModel();
        assertThat(placement).isEqualTo(Placement.of(1, -2, 0.5, Math.PI / 2));
    }

    @Test
    void oneValueDoesForATupleOfOneAndATuplesFirstForOne() {
        var model = Worlds.of("model ( name [\"a\" \"b\"] mass [3 4] color 5 ctrl [\"one x y\" \"two\"] )")
                .model();
        assertThat(model.name()).isEqualTo("a");
        assertThat(model.traits().mass()).isEqualTo(3);
        assertThat(model.traits().controllers())
                .containsExactly(new Traits.Controller("one", "x y"), new Traits.Controller("two", ""));
    }

    @Test
    void textThatIsNotUnicodeIsReadAsLatin1() {
        var world = new Worlds()
                .and("test.world", "# J\u00f6rg\nmodel ( name \"K\u00fcche\" )".getBytes(StandardCharsets.ISO_8859_1));
        assertThat(world.model().name()).isEqualTo("K\u00fcche");
        assertThat(new Worlds()
                        .and("test.world", "\uFEFFmodel ( name \"K\u00fcche\" )")
                        .model()
                        .name())
                .isEqualTo("K\u00fcche");
    }

    @Test
    void macrosBuildUponEachOther() {
        var worlds = Worlds.of("""
                define base model ( size [1 2 3] color "blue" mass 4 )
                define wide base ( size [9 2 3] )
                wide ( name "a" )
                wide ( name "b" mass 5 )
                base ( name "c" )
                """);
        var named = worlds.named();
        assertThat(named.get("a").traits().size()).isEqualTo(new Size(9, 2, 3));
        assertThat(named.get("a").traits().mass()).isEqualTo(4);
        assertThat(named.get("a").macro()).isEqualTo("wide");
        assertThat(named.get("c").macro()).isEqualTo("base");
        assertThat(named.get("b").traits().mass()).isEqualTo(5);
        assertThat(named.get("c").traits().size()).isEqualTo(new Size(1, 2, 3));
    }

    @Test
    void childrenOfAMacroComeBeforeItsUsers() {
        assertThat(Worlds.of("""
                        define inner model ( model ( name "deep" ) )
                        define outer inner ( model ( name "first" ) inner ( name "second" ) )
                        outer ( name "o" model ( name "last" ) )
                        """).names())
                .containsExactly("o", "o.deep", "o.first", "o.second", "o.second.deep", "o.last");
    }

    @Test
    void aMacroMayUseInItsBodyWhatIsDefinedLater() {
        assertThat(Worlds.of("""
                        define outer model ( inner ( name "i" ) )
                        define inner model ( )
                        outer ( name "o" )
                        """).names()).containsExactly("o", "o.i");
    }

    @Test
    void theFirstOfTwoDefinitionsCounts() {
        var worlds = Worlds.of("""
                define a model ( mass 1 )
                define a model ( mass 2 )
                a ( )
                """);
        assertThat(worlds.model().traits().mass()).isEqualTo(1);
        assertThat(worlds.warnings())
                .containsExactly("test.world:2:8: 'a' is defined again, without effect: its first definition counts,"
                        + " at test.world:1:8.\n    Give one of them another name.");
    }

    @Test
    void aFileThatIsIncludedTwiceDefinesNothingTwice() {
        var worlds = Worlds.of("include \"a.inc\"\ninclude \"a.inc\"\na ( )").and("a.inc", "define a model ( )");
        assertThat(worlds.warnings()).isEmpty();
        assertThat(worlds.names()).containsExactly("model:0");
    }

    @Test
    void theRestOfALineBehindAnIncludeIsLeftOut() {
        assertThat(Worlds.of("include \"a.inc\" ( whatever\nmodel ( name \"b\" )")
                        .and("a.inc", "model ( name \"a\" )")
                        .names())
                .containsExactly("a", "b");
    }

    @Test
    void anIncludeMayStandInsideOfAModel() {
        assertThat(Worlds.of("model (\n name \"a\"\n include \"parts.inc\"\n)")
                        .and("parts.inc", "model ( name \"b\" )")
                        .names())
                .containsExactly("a", "a.b");
    }

    @Test
    void placesAreThoseOfTheFileThatSaysSo() {
        var worlds = Worlds.of("include \"a.inc\"\n\na ( nonsense 2 )").and("a.inc", "\ndefine a model ( rubbish 1 )");
        assertThat(worlds.warnings())
                .containsExactly(
                        "a.inc:2:18: 'rubbish' is not known in a model and has no effect.",
                        "test.world:3:5: 'nonsense' is not known in a model and has no effect.");
        assertThat(worlds.model().location()).isEqualTo(new Location("test.world", 3, 1));
    }

    @Test
    void whatAMacroHasWrongIsReportedOnce() {
        assertThat(Worlds.of("define a model ( rubbish 1 model ( nonsense 1 ) )\n" + "a ( )\n".repeat(50))
                        .warnings())
                .hasSize(2);
    }
}
