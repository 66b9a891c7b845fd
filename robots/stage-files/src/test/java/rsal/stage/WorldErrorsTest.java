package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// What is told of worlds that can't be read, or not all of them.
class WorldErrorsTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "model ( mass --3 )         | 14 | '--3' is not a number.",
                "model ( mass 1e999 )       | 9 | 'mass' must be from 0 to 1000000000, not '1e999'.",
                "model ( mass \"much\" )    | 9 | 'mass' must be a number, not 'much'.",
                "model ( name \"a )         | 14 | The text that begins here is not closed.",
                "model ( mass 1             | 7 | The ( of 'model' is not closed.",
                "model ( mass 1 ) )         | 18 | This ) closes nothing.",
                "model ( pose [1 2 3 4 )    | 14 | This [ is not closed.",
                "model ( pose [1 2 3 x] )   | 21 | 'x' can't stand in a tuple.",
                "model ( mass )             | 9 | 'mass' has no value.",
                "model ( color red )        | 9 | 'color' has no value.",
                "model ( 5 )                | 9 | Here a name was expected, not '5'.",
                "model ( mass 1, )          | 15 | ',' is not allowed here.",
                "model { mass 1 }           | 7 | '{' is not allowed here.",
                "define a                   | 1 | 'define' is incomplete.",
                "define a b ( )             | 10 | 'b' is neither a type nor a macro that is defined above.",
                "model ( define a model ( ) ) | 9 | 'define' can't stand inside of 'model'.",
                "include                    | 1 | 'include' names no file in quotes.",
                "include \"no.inc\"         | 1 | There is no file 'no.inc'.",
                "model ( bitmap \"no.png\" ) | 9 | There is no file 'no.png'.",
                "model ( pose [1 2 90] )    | 9 | 'pose' needs 4 numbers, [x y z a], but has 3.",
                "model ( size [1 2] )       | 9 | 'size' needs 3 numbers, [x y z], but has 2.",
                "model ( size 1 )           | 9 | 'size' needs 3 numbers, [x y z], but is '1'.",
                "model ( size [1 -2 1] )    | 17 | Value 2 of 'size' must be from 0 to 1000000 m, not '-2'.",
                "model ( pose [1 \"b\" 0 0] ) | 17 | Value 2 of 'pose' must be a number, not 'b'.",
                "model ( pose [9999999 0 0 0] ) | 15 | Value 1 of 'pose' must be from -1000000 to 1000000 m, not '9999999'.",
                "model ( mass -1 )          | 9 | 'mass' must be at least 0, not '-1'.",
                "model ( update_interval 0 ) | 9 | 'update_interval' must be positive, not '0'.",
                "interval_sim -5            | 1 | 'interval_sim' must be positive, not '-5'.",
                "resolution 0               | 1 | 'resolution' must be positive, not '0'.",
                "unit_length \"inch\"       | 1 | There is no unit_length 'inch'.",
                "unit_angle \"degree\"      | 1 | There is no unit_angle 'degree'.",
                "position ( drive \"omnI\" ) | 12 | There is no drive 'omnI'.",
                "position ( drive \"car\" wheelbase 0 ) | 24 | 'wheelbase' must be positive, not '0'.",
                "position ( velocity_bounds [1 -1 0 0 0 0 0 0] ) | 12 "
                        + "| 'velocity_bounds' has its least value '1' above its greatest '-1'.",
                "ranger ( sensor ( samples 0 ) ) | 19 | 'samples' must be a whole number from 1 to 100000, not '0'.",
                "ranger ( sensor ( range [5 0] ) ) | 19 | 'range' has its least value '5' above its greatest '0'.",
                "ranger ( sensor ( fov 700 ) )  | 19 | 'fov' must be from 0 to 360 degrees, not '700'.",
                "ranger ( sensor ( noise [-1 0 0] ) ) | 19 "
                        + "| The first value of 'noise' is a variance and must not be negative, not '-1'.",
                "blobfinder ( colors_count 2 colors [\"red\"] ) | 14 | 'colors_count' is 2, but 'colors' names 1.",
                "blobfinder ( image [0 60] ) | 21 | Value 1 of 'image' must be from 1 to 10000, not '0'.",
                "gripper ( paddle_state [\"ajar\" \"up\"] ) | 11 "
                        + "| 'paddle_state' has 'ajar' where 'open' or 'closed' was expected.",
                "gripper ( paddle_size [2 0.1 0.4] ) | 24 | Value 1 of 'paddle_size' must be from 0 to 1, not '2'.",
                "actuator ( axis [0 0 0] )   | 12 | 'axis' must not be [0 0 0].",
                "blinkenlight ( dutycycle 2 ) | 16 | 'dutycycle' must be from 0 to 1, not '2'.",
                "model ( block ( points 1 point[0] [0 0] ) ) | 17 | 'points' must be a whole number from 2 to 10000, not '1'.",
                "model ( block ( points 3 point[0] [0 0] point[1] [1 0] ) ) | 17 "
                        + "| The block has no 'point[2]', though 'points' is 3.",
                "model ( block ( points 2 point[0] [0 0] point[1] [1] ) ) | 41 "
                        + "| 'point[1]' needs 2 numbers, [x y], but has 1."
            })
    void errorsAreReportedWithTheirPlace(String text, int column, String message) {
        assertThat(Worlds.of("\n" + text).errors())
                .isNotEmpty()
                .first()
                .asString()
                .satisfies(problem -> assertThat(problem.lines().toList().getFirst())
                        .isEqualTo("test.world:2:%d: %s".formatted(column, message)));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "define a modle ( )          | Maybe 'model' was meant?",
                "define cart position ( )\\ncrat ( ) | Maybe 'cart' was meant?",
                "define a b ( )\\ndefine b model ( ) | It is defined at test.world:2:8; put that first.",
                "model ( color red )         | Maybe \"red\" was meant? Texts stand in \" \".",
                "model ( pose [1 2 90] )     | Maybe [1 2 0 90]: x, y and z in m, and the heading in degrees.",
                "model ( size [1 2] )        | Maybe [1 2 1]: length, width and height in m.",
                "model { }                   | Maybe ( ) was meant?",
                "position ( drive \"omin\" )  | Maybe 'omni' was meant?",
                "laser ( )                   | Write ranger ( sensor ( range [0 8] fov 180 samples 180 ) ), with the "
                        + "values that this one has.",
                "unit_length \"cm\" ranger ( sensor ( range [-5 500] ) ) | Maybe [0 500]?",
                "unit_length \"mm\" ranger ( sensor ( noise [-10 0 0] ) ) | Maybe it was meant to be '10'?",
                "include map.inc # the map   | Maybe include \"map.inc\"?",
                "define puck model ( ) puck pose [0 0 0 0] | Models are written as puck ( ... ).",
                "position pose [0 0 0 0]     | Models are written as position ( ... ).",
                "model ( wifi ( ) )          | Nothing simulates radios; take it out if its robots can do without."
            })
    void whatWasMeantIsGuessed(String text, String remedy) {
        assertThat(Worlds.of(text.replace("\\n", "\n")).errors().getFirst()).endsWith("\n    " + remedy);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "model ( pose [1e300 0 0 0] ) | Value 1 of 'pose' must be from -1000000 to 1000000 m, not '1.0E300'. "
                        + "| Lengths are in m here; maybe 'unit_length' is wrong.",
                "unit_length \"mm\" model ( pose [0 2e9 0 0] ) | Value 2 of 'pose' must be from -1000000 to 1000000 m, "
                        + "not '2000000000'. | Lengths are in mm here; maybe 'unit_length' is wrong.",
                "model ( pose [0 0 0 -1e300] ) | Value 4 of 'pose' must be from -1000000000 to 1000000000 degrees, not "
                        + "'-1.0E300'. | Angles are in degrees here; maybe 'unit_angle' is wrong.",
                "model ( size [1 1e300 1] ) | Value 2 of 'size' must be from 0 to 1000000 m, not '1.0E300'. "
                        + "| Lengths are in m here; maybe 'unit_length' is wrong.",
                "model ( size [1 1 -2] ) | Value 3 of 'size' must be from 0 to 1000000 m, not '-2'. "
                        + "| Maybe 2, without the minus?",
                "model ( mass 1e300 ) | 'mass' must be from 0 to 1000000000, not '1.0E300'. | ``",
                "model ( mass \"1e999\" ) | 'mass' must be from 0 to 1000000000, not '1e999'. | ``",
                "quit_time 1e300 | 'quit_time' must be from 0 to 1000000000, not '1.0E300'. | ``",
                "interval_sim 1e300 | 'interval_sim' must be positive and at most 1000000000, not '1.0E300'. | ``",
                "model ( fiducial_return 1e12 ) | 'fiducial_return' must be a whole number from -2147483648 to "
                        + "2147483647, not '1000000000000'. | ``",
                "ranger ( sensor ( samples 2000000000 ) ) | 'samples' must be a whole number from 1 to 100000, not "
                        + "'2000000000'. | ``",
                "ranger ( sensor ( range [0 1e300] ) ) | Value 2 of 'range' must be from -1000000000 to 1000000000 m, "
                        + "not '1.0E300'. | Lengths are in m here; maybe 'unit_length' is wrong.",
                "unit_angle \"radians\" ranger ( sensor ( fov 180 ) ) | 'fov' must be from 0 to 6.28319 rad, not '180'. "
                        + "| Angles are in rad here; maybe 'unit_angle' is wrong.",
                "model ( block ( points 2000000000 ) ) | 'points' must be a whole number from 2 to 10000, not "
                        + "'2000000000'. | ``"
            })
    void whatIsTooLargeIsReportedWithItsRange(String text, String message, String remedy) {
        assertThat(Worlds.of(text).errors())
                .singleElement()
                .asString()
                .endsWith(": " + message + (remedy.isEmpty() ? "" : "\n    " + remedy));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "model ( pose [1 2] ) | Maybe [1 2 0 0]: x, y and z in m, and the heading in degrees.",
                "model ( pose [] ) | Write [0 0 0 0], say: x, y and z in m, and the heading in degrees.",
                "model ( pose \"here\" ) | Write [0 0 0 0], say: x, y and z in m, and the heading in degrees.",
                "unit_length \"cm\" unit_angle \"radians\" model ( size [4] ) "
                        + "| Maybe [4 40 100]: length, width and height in cm.",
                "unit_angle \"radians\" model ( origin [1 2 1.57] ) "
                        + "| Maybe [1 2 0 1.57]: x, y and z in m, and the heading in rad.",
                "position ( velocity_bounds [1 2] ) | Maybe [1 2 -1 1 -1 1 -90 90]: the least and the greatest forward, "
                        + "to the left and up in m/s, and turning in degrees/s.",
                "position ( acceleration_bounds 3 ) | Maybe [3 1 -1 1 -1 1 -90 90]: the least and the greatest forward, "
                        + "to the left and up in m/s², and turning in degrees/s².",
                "position ( velocity [1] ) | Maybe [1 0 0 0]: forward, to the left and up in m/s, and turning in "
                        + "degrees/s.",
                "model ( color_rgba [1 0 0] ) | Maybe [1 0 0 1]: red, green, blue and opacity, each from 0 to 1.",
                "ranger ( sensor ( range 8 ) ) | Maybe [0 8]: the least and the greatest in m.",
                "blobfinder ( image [160] ) | Maybe [160 60]: columns and rows.",
                "model ( obstacle_return \"yes\" ) | Maybe 1, for yes?",
                "model ( mass \"much\" ) "
                        + "| Numbers are written like 0.4; unit_length and unit_angle say in which units.",
                "model ( block ( points 3 point[0] [0 0] point[1] [1 0] ) ) "
                        + "| Maybe 'points 2', as there are point[0] to point[1]?",
                "model ( block ( points 4 point[0] [0 0] point[1] [1 0] point[3] [0 1] ) ) "
                        + "| Write 'point[2] [X Y]'; they are counted from 0 on, without a gap.",
                "model ( block ( point[0] [0 0] point[1] [1 0] point[2] [0 1] ) ) "
                        + "| Maybe 'points 3', as there are point[0] to point[2]?",
                "model ( block ( ) ) | Write points N, then point[0] [X Y] and so on to the last, N - 1.",
                "position ( wheelbase -1 ) | Maybe 1, without the minus?",
                "actuator ( axis [0 0 0] ) | Write [1 0 0] for forward, [0 0 1] for up."
            })
    void whatIsMissingIsProposed(String text, String remedy) {
        assertThat(Worlds.of(text).errors()).singleElement().asString().endsWith("\n    " + remedy);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "model ( pose [1e999 0 0 0] ) | 1:15: Value 1 of 'pose' must be from -1000000 to 1000000 m, not '1e999'. "
                        + "| Lengths are in m here; maybe 'unit_length' is wrong.",
                "model ( mass 5kg ) | 1:14: '5kg' is not a number. "
                        + "| Units are not written here; unit_length and unit_angle give those of all numbers.",
                "model ( size [1m 1 1] ) | 1:15: '1m' is not a number. "
                        + "| Units are not written here; unit_length and unit_angle give those of all numbers.",
                "ranger ( sensor ( samples 5px ) ) | 1:27: '5px' is not a number. "
                        + "| Units are not written here; unit_length and unit_angle give those of all numbers.",
                "model ( pose [nan 0 0 0] ) | 1:15: 'nan' can't stand in a tuple. | Only finite numbers can be written.",
                "model ( mass inf ) | 1:9: 'mass' has no value. | Only finite numbers can be written.",
                "model ( boundary true ) | 1:9: 'boundary' has no value. | Maybe 1, for yes?",
                "model ( boundary no ) | 1:9: 'boundary' has no value. | Maybe 0, for no?",
                "model ( mass color \"red\" ) | 1:9: 'mass' has no value. | Write one before 'color'.",
                "model ( pose 1 2 0 90 ) | 1:9: 'pose' has 4 values. | Several stand in [ ]: pose [1 2 0 90].",
                "model ( ctrl \"a\" \"b\" ) | 1:9: 'ctrl' has 2 values. | Several stand in [ ]: ctrl [\"a\" \"b\"].",
                "model ( size [0,4 0,4 0,2] ) | 1:16: ',' is not allowed here. "
                        + "| Values are set apart by blanks, and decimals by a point.",
                "model ( color 'red' ) | 1:15: ''' is not allowed here. | Texts stand in \" \".",
                "model ( color “red” ) | 1:15: '“' is not allowed here. | Texts stand in \" \".",
                "model ( )\\n// a wall and a door\\n | 2:1: '/' is not allowed here. | Comments begin with #.",
                "/* a wall\\n and a door */ model ( ) | 1:1: '/' is not allowed here. | Comments begin with #.",
                "model ( namе \"a\" ) | 1:12: 'е' is not allowed here. "
                        + "| Names are made of a to z, A to Z, digits and _.",
                "inlcude \"a.inc\"\\na ( ) | 1:1: 'inlcude' is not known in a world. | Maybe 'include' was meant?",
                "Include \"a.inc\"\\nmodel ( ) | 1:1: 'Include' is not known in a world. | Maybe 'include' was meant?",
                "include a.inc\\na ( ) | 1:1: 'include' names no file in quotes. | Maybe include \"a.inc\"?",
                "include \"a.inc\\na ( ) | 1:1: 'include' does not close the name of its file. "
                        + "| Maybe include \"a.inc\"?",
                "include\\na ( ) | 1:1: 'include' names no file in quotes. | Write include \"FILE\" on one line.",
                "model ( name lab/desk size [1 1 1] ) | 1:14: 'lab/desk' stands without quotes. "
                        + "| Maybe \"lab/desk\" was meant? Texts stand in \" \".",
                "model ( block ( points 2 point [0] [0 0] point[1] [1 1] ) ) | 1:26: There is a blank between 'point' and its "
                        + "index. | Maybe point[0] was meant?",
                "Define a model ( ) | 1:1: 'Define' has no value. | Maybe 'define' was meant?",
                "model ( name \"a )\\nmodel ( ) | 1:14: The text that begins here is not closed. "
                        + "| Close it with \" on the same line.",
                "model ( size [1 1 1\\n color \"red\" ) | 1:14: This [ is not closed. | Close it with ].",
                "define a position (\\n ranger ( sensor ( )\\n)\\na ( )\\na ( ) | 1:19: The ( of 'position' is not closed. "
                        + "| Close it with ), maybe before 'a' at test.world:4:1.",
                "ranger ( sensor ( range [0 -5] ) ) | 1:19: 'range' has its least value '0' above its greatest '-5'. "
                        + "| Maybe 5, without the minus?",
                "position ( velocity_bounds [0 1 0 0 0 0 90 -90] ) | 1:12: 'velocity_bounds' has its least value '90' above "
                        + "its greatest '-90'. | Maybe the two were mixed up."
            })
    void oneErrorIsReportedOnceAndForWhatItIs(String text, String message, String remedy) {
        assertThat(Worlds.of(text.replace("\\n", "\n")).errors())
                .containsExactly("test.world:" + message + "\n    " + remedy);
    }

    @Test
    void bracesAndTheLikeAreTakenForWhatTheyMean() {
        assertThat(Worlds.of("position { size: [1, 2, 3]; color = 'red'; }\nmodel { mass: 1; }")
                        .errors())
                .extracting(problem -> problem.lines().findFirst().orElseThrow())
                .containsExactly(
                        "test.world:1:10: '{' is not allowed here.",
                        "test.world:1:16: ':' is not allowed here.",
                        "test.world:1:20: ',' is not allowed here.",
                        "test.world:1:27: ';' is not allowed here.",
                        "test.world:1:35: '=' is not allowed here.",
                        "test.world:1:37: ''' is not allowed here.",
                        "test.world:1:44: '}' is not allowed here.",
                        "test.world:2:7: '{' is not allowed here.",
                        "test.world:2:13: ':' is not allowed here.",
                        "test.world:2:16: ';' is not allowed here.",
                        "test.world:2:18: '}' is not allowed here.");
    }

    @Test
    void errorsAreReportedInTheOrderOfLines() {
        assertThat(Worlds.of("model ( mass \"a\" )\ninclude \"no.inc\"\nmodel ( mass --3 )")
                        .errors())
                .extracting(problem -> problem.substring(0, "test.world:1".length()))
                .containsExactly("test.world:1", "test.world:2", "test.world:3");
    }

    @Test
    void severalErrorsAreReportedAtOnce() {
        assertThat(Worlds.of("""
                        include "no.inc"
                        model ( mass --3 )
                        model ( pose [1 2] )
                        model ( bitmap "no.png" colour "red" )
                        """).errors()).hasSize(4);
    }

    @Test
    void whatAMissingFileMayDefineIsNotReportedAsMissing() {
        assertThat(Worlds.of("include \"no.inc\"\ndefine b a ( )\na ( )\nb ( )").errors())
                .containsExactly("test.world:1:1: There is no file 'no.inc'.\n"
                        + "    Maybe it is in another folder: those in the environment's STAGEPATH are searched, too.");
    }

    @Test
    void aWorldThatIsNotThereIsNamed() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> StageWorld.read("no.world", WorldFiles.in(new Worlds().source())))
                .withMessage("no.world: There is no file 'no.world'.");
    }

    @Test
    void whatIsNoTextIsReportedAtOnceAndOnlyOnce() {
        assertThat(Worlds.of("model ( )\n\u0089PNG\u001a\n\u0000\u0000\u0001\u0002")
                        .errors())
                .containsExactly("test.world:3:1: 'test.world' is not a text file: there is a byte 0 in it.\n"
                        + "    Maybe it is another file, or one to be saved as UTF-8.");
        assertThat(Worlds.of("include \"a.inc\"").and("a.inc", "model\u0008").errors())
                .hasSize(1)
                .first()
                .asString()
                .startsWith("a.inc:1:6: 'a.inc' is not a text file");
        assertThat(Worlds.of("# made by hand\f\r\n\tmodel ( )\u001a").errors())
                .as("blanks, and the end of a file of DOS")
                .noneMatch(problem -> problem.contains("not a text"));
    }

    @Test
    void theFileThatErrorsAreInIsNamed() {
        assertThat(Worlds.of("include \"a.inc\"")
                        .and("a.inc", "\nmodel ( mass \"x\" )")
                        .errors())
                .containsExactly("a.inc:2:9: 'mass' must be a number, not 'x'.\n"
                        + "    Numbers are written like 0.4; unit_length and unit_angle say in which units.");
    }

    @Test
    void aCircleOfIncludesIsReported() {
        assertThat(Worlds.of("include \"a.inc\"")
                        .and("a.inc", "include \"b.inc\"")
                        .and("b.inc", "include \"a.inc\"")
                        .errors())
                .containsExactly("b.inc:1:1: 'a.inc' includes itself: test.world → a.inc → b.inc → a.inc.\n"
                        + "    Take one of these includes out.");
    }

    @Test
    void aMacroThatHoldsItselfIsReported() {
        assertThat(Worlds.of("define a model ( b ( ) )\ndefine b model ( a ( ) )\na ( )")
                        .errors())
                .containsExactly("test.world:2:18: 'a' is part of its own definition at test.world:1:8.\n"
                        + "    Take it out there.");
    }

    @Test
    void aMacroThatBuildsUponItselfIsReported() {
        String remedy = "\n    Write define NAME BASE ( ... ), BASE being a type such as 'model' or 'position'.";
        assertThat(Worlds.of("define a a()\na()").errors())
                .containsExactly("test.world:1:10: 'a' builds upon itself." + remedy);
        assertThat(Worlds.of("define a b()\ndefine b c()\ndefine c a()\na() b() c()")
                        .errors())
                .containsExactly("test.world:1:10: 'a' builds upon itself: a → b → c → a." + remedy);
        assertThat(Worlds.of("define a b()\ndefine b b()").errors())
                .containsExactly(
                        "test.world:1:10: 'b' is neither a type nor a macro that is defined above.\n"
                                + "    It is defined at test.world:2:8; put that first.",
                        "test.world:2:10: 'b' builds upon itself." + remedy);
    }

    @Test
    void aBitmapWithoutANameIsReportedAsWithoutEffect() {
        assertThat(Worlds.of("model ( bitmap \"\" )").warnings())
                .containsExactly("test.world:1:9: 'bitmap' names no file and has no effect.\n"
                        + "    Name an image, or remove it.");
    }

    @Test
    void obsoleteTypesAreReportedOnlyWhereTheyAreUsed() {
        var worlds = Worlds.of("define sick laser ( samples 180 )\ndefine disc puck ( )\nmodel ( )");
        assertThat(worlds.names()).containsExactly("model:0");
        assertThat(Worlds.of("define sick laser ( )\nposition ( sick ( ) )").errors())
                .containsExactly(
                        "test.world:2:12: 'sick' is made of 'laser', a type that later versions of Stage dropped.\n"
                                + "    Write ranger ( sensor ( range [0 8] fov 180 samples 180 ) ), with the values that this"
                                + " one has.");
    }

    @Test
    void aTypeThatNobodyKnowsIsLeftOutWithAWarning() {
        var worlds = Worlds.of("model ( teleporter ( power 3 model ( ) ) model ( ) )\nspeech ( )");
        assertThat(worlds.names()).containsExactly("model:0", "model:0.model:0");
        assertThat(worlds.warnings())
                .containsExactly(
                        "test.world:1:9: 'teleporter' is neither a type nor a macro; it is ignored with all that is"
                                + " in it.\n    Maybe an include is missing.",
                        "test.world:2:1: 'speech' is a type that later versions of Stage dropped; it is ignored.");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "model ( colour \"red\" ) | 9 | 'colour' is not known in a model and has no effect. "
                        + "| Maybe 'color' was meant?",
                "model ( laser_return 1 ) | 9 | 'laser_return' is not known in a model and has no effect. "
                        + "| Older versions of Stage knew it. Rangers look at ranger_return.",
                "model ( xyzzy 1 )        | 9 | 'xyzzy' is not known in a model and has no effect. | ``",
                "ranger ( spose[0] [0 0 0] spose[1] [0 0 0] ) | 10 | 'spose[0]' is not known in a ranger and has no "
                        + "effect. | Older versions of Stage knew it. Write one sensor ( pose [X Y Z A] ) for each "
                        + "transducer.",
                "ranger ( range [0 8] )   | 10 | 'range' is not known in a ranger and has no effect. "
                        + "| Put it into a sensor ( ... ) of this ranger.",
                "interval_real 100        | 1 | 'interval_real' is not known in a world and has no effect. "
                        + "| Older versions of Stage knew it. A run's pace is chosen when it is started.",
                "window ( zoom 3 )        | 10 | 'zoom' is not known in a window and has no effect. | ``",
                "model ( color \"rde\" )  | 9 | There is no color 'rde'. | Maybe 'red' was meant?",
                "model ( color \"ultraviolettish\" ) | 9 | There is no color 'ultraviolettish'. "
                        + "| Stage would take red.",
                "position ( ctrl \"hunt 3\" ranger ( ) ) | 12 | Controller 'hunt' is a program for Stage and can't be "
                        + "loaded here. | The robot wanders instead. Give it a behavior or an agent in a scenario.",
                "position ( ctrl \"wander\" ) | 12 | Controller 'wander' is for robots that have a ranger. "
                        + "| The robot stands still: it has no ranger to wander by. Give it one, or an agent in a "
                        + "scenario.",
                "position ( camera ( ) )  | 12 | A camera gives no images here. "
                        + "| A blobfinder sees colors, a fiducial markers.",
                "model ( size [0 0 0] )   | 9 | What has this 'size' has no body: nothing runs into it or sees it. "
                        + "| Give it a length and a width, as [0.4 0.4 1].",
                "sensor ( )               | 1 | 'sensor' has no effect here. | Put it into a ranger ( ... ).",
                "model ( window ( ) )     | 9 | 'window' has no effect here. "
                        + "| It belongs to the world, outside of models.",
                "block ( )                | 1 | 'block' has no effect here. | It shapes the model that it stands in.",
                "model ( name \"a\" ) model ( name \"a\" ) | 20 | There is more than one model 'a'; this one is called "
                        + "'a~2' here. | Give each a name of its own."
            })
    void whatHasNoEffectIsWarnedOfOnce(String text, int column, String message, String remedy) {
        assertThat(Worlds.of(text).warnings())
                .containsExactly(
                        "test.world:1:%d: %s".formatted(column, message) + (remedy.isEmpty() ? "" : "\n    " + remedy));
    }

    @ParameterizedTest
    @CsvSource({"3.75.2, 3.75", "7.-1, 7.", ".5.5, .5", "1e3.5, 1e3", "+4+4, +4"})
    void aNumberThatGoesOnAsNoneIsReadAsStageReadsIt(String written, String read) {
        Worlds worlds = Worlds.of("position ( mass %s )".formatted(written));
        assertThat(worlds.warnings())
                .containsExactly(
                        "test.world:1:17: '%s' is read as %s, as Stage reads it.\n    Write the number that is meant."
                                .formatted(written, read));
    }

    @Test
    void whatOnlyViewersLookAtIsNotWarnedOf() {
        assertThat(Worlds.of("""
                        threads 2 speedup 1 paused 0 show_clock 1
                        window ( size [600 400] scale 30 center [0 0] rotate [0 0] show_data 1 show_trailrise 0 )
                        model ( gui_nose 1 gui_grid 0 gui_move 1 gui_outline 0 trail_length 3 map_resolution 0.1 friction 1 )
                        """).warnings()).isEmpty();
    }

    @Test
    void howStageRunsAWorldIsDecidedElsewhere() {
        assertThat(Worlds.of("interval_sim 100\nspeedup 10 paused 1").warnings())
                .containsExactly(
                        "test.world:2:1: 'speedup' has no effect here.\n"
                                + "    Choose the speed of a run when you start it: --speed FACTOR.",
                        "test.world:2:12: 'paused' has no effect here.\n    Pause the run on its page.");
    }

    @Test
    void errorsDoNotHideWarnings() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Worlds.of("""
                                model ( xyzzy 1 )
                                model ( name "a" mass "x" ) model ( name "a" )
                                """).read())
                .satisfies(e -> {
                    assertThat(e.problems()).hasSize(1);
                    assertThat(e.warnings())
                            .extracting(Problem::toString)
                            .satisfiesExactly(
                                    first -> assertThat(first).startsWith("test.world:1:9: 'xyzzy'"),
                                    second -> assertThat(second).contains("There is more than one model 'a'"));
                    assertThat(e).hasMessageContaining("\nWarning: test.world:1:9: 'xyzzy'");
                });
    }

    @Test
    void whatIsTooMuchDoesNotHideWarnings() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Worlds.of("model ( xyzzy 1 )\n" + "model ( mass \"x\" )\n".repeat(60))
                        .read())
                .satisfies(e -> assertThat(e.warnings()).hasSize(1));
    }

    @Test
    void endlessWarningsAreCutShort() {
        var text = new StringBuilder();
        for (int i = 0; i < 700; i++) {
            text.append("model ( xyzzy 1 )\n");
        }
        List<String> warnings = Worlds.of(text.toString()).warnings();
        assertThat(warnings).hasSize(501).last().isEqualTo("test.world: There are 200 more warnings.");
    }

    @Test
    void endlessErrorsAreCutShort() {
        assertThat(Worlds.of("model ( mass \"x\" )\n".repeat(1000)).errors()).hasSize(50);
    }

    @Test
    void anImageThatCanNotBeReadIsReportedWhereItIsNamed() {
        assertThat(Worlds.of("model ( bitmap \"a.png\" )").and("a.png", "what").errors())
                .singleElement()
                .asString()
                .startsWith("test.world:1:9: Image 'a.png' can't be read: it is not an image");
    }
}
