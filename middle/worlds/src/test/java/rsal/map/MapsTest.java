package rsal.map;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static rsal.data.OccupancyGrid.FREE;
import static rsal.data.OccupancyGrid.OCCUPIED;
import static rsal.data.OccupancyGrid.UNKNOWN;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;

class MapsTest {
    private static final Location HERE = new Location("hunt.yaml", 3, 8);
    private static final String LAB = """
            image: lab.pgm
            resolution: 0.5
            origin: [-1, -2, 0]
            negate: 0
            occupied_thresh: 0.65
            free_thresh: 0.196
            """;
    /// Black, gray, white above white, white, black.
    private static final String PGM = """
            P2
            # drawn by hand
            3 2
            255
            0 128 255
            255 255 0
            """;

    @TempDir
    private Path folder;

    private Maps maps;

    @BeforeEach
    void setUp() throws IOException {
        maps = new Maps(FileSource.folder(folder));
        write("lab.yaml", LAB);
        write("lab.pgm", PGM);
    }

    @Test
    void readsAMapWithTheLowestRowFirst() {
        OccupancyGrid grid = maps.read("lab.yaml", HERE);
        assertThat(grid.width()).isEqualTo(3);
        assertThat(grid.height()).isEqualTo(2);
        assertThat(grid.resolution()).isEqualTo(0.5);
        assertThat(grid.originX()).isEqualTo(-1);
        assertThat(grid.originY()).isEqualTo(-2);
        assertThat(grid.cells()).containsExactly(FREE, FREE, OCCUPIED, OCCUPIED, UNKNOWN, FREE);
    }

    @Test
    void readsRawPgmWithOneAndTwoBytes() throws IOException {
        write("lab.pgm", "P5 3 2 255\n", 0, 128, 255, 255, 255, 0);
        assertThat(maps.read("lab.yaml", HERE).cells()).containsExactly(FREE, FREE, OCCUPIED, OCCUPIED, UNKNOWN, FREE);
        write("lab.pgm", "P5 2 1 1000\n", 0, 0, 3, 232);
        assertThat(maps.read("lab.yaml", HERE).cells()).containsExactly(OCCUPIED, FREE);
    }

    @Test
    void readsPng() throws IOException {
        write("lab.yaml", LAB.replace("lab.pgm", "lab.png"));
        Files.write(
                folder.resolve("lab.png"), png(0xff000000, 0xff808080, 0xffffffff, 0xffffffff, 0x80ffffff, 0xff000000));
        assertThat(maps.read("lab.yaml", HERE).cells()).containsExactly(FREE, FREE, OCCUPIED, OCCUPIED, UNKNOWN, FREE);
        write("lab.yaml", LAB.replace("lab.pgm", "lab.png") + "mode: scale\n");
        assertThat(maps.read("lab.yaml", HERE).cells())
                .containsExactly(FREE, UNKNOWN, OCCUPIED, OCCUPIED, UNKNOWN, FREE);
    }

    @Test
    void negateSwapsBlackAndWhite() throws IOException {
        write("lab.yaml", LAB.replace("negate: 0", "negate: 1"));
        assertThat(maps.read("lab.yaml", HERE).cells())
                .containsExactly(OCCUPIED, OCCUPIED, FREE, FREE, UNKNOWN, OCCUPIED);
    }

    /// By Player's mapfile: the mean of all channels, opacity among them, darker than 0.95 or lighter than 0.1.
    @Test
    void theModeMapfileReadsAsPlayerDoes() throws IOException {
        write("lab.yaml", "image: lab.pgm\nresolution: 0.5\nmode: mapfile\n");
        write("lab.pgm", "P2 4 1 100 4 6 89 91");

        OccupancyGrid grid = maps.read("lab.yaml", HERE);

        assertThat(grid.cells()).containsExactly(OCCUPIED, UNKNOWN, UNKNOWN, FREE);
        assertThat(grid.originX()).isEqualTo(-1);
        assertThat(grid.originY()).isEqualTo(-0.25);

        write("lab.yaml", "image: lab.png\nresolution: 0.5\nmode: mapfile\norigin: [3, 4, 0]\n");
        Files.write(
                folder.resolve("lab.png"), png(0xff000000, 0x00000000, 0xffffffff, 0x80ffffff, 0xffff0000, 0xfffefefe));
        grid = maps.read("lab.yaml", HERE);
        assertThat(grid.cells()).containsExactly(UNKNOWN, UNKNOWN, FREE, UNKNOWN, OCCUPIED, FREE);
        assertThat(grid.originX()).isEqualTo(3);

        write("lab.yaml", "image: lab.pgm\nresolution: 0.5\nmode: mapfile\nnegate: 1\n");
        assertThat(maps.read("lab.yaml", HERE).cells()).containsExactly(FREE, FREE, UNKNOWN, UNKNOWN);
    }

    @ParameterizedTest
    @ValueSource(strings = {"bmp", "gif", "jpg"})
    void readsOtherImages(String format) throws IOException {
        var image = new BufferedImage(16, 8, BufferedImage.TYPE_INT_RGB);
        image.createGraphics().fillRect(0, 0, 8, 8);
        var bytes = new ByteArrayOutputStream();
        assertThat(ImageIO.write(image, format, bytes)).isTrue();
        Files.write(folder.resolve("lab.pgm"), bytes.toByteArray());

        OccupancyGrid grid = maps.read("lab.yaml", HERE);

        assertThat(grid.at(2, 4)).isEqualTo(FREE);
        assertThat(grid.at(13, 4)).isEqualTo(OCCUPIED);
    }

    @Test
    void aMapMayBeDrawnWithLetters() throws IOException {
        write("lab.yaml", "resolution: 0.5\ndrawing: |\n  ####\n  #.?#\n  # \n");

        OccupancyGrid grid = maps.read("lab.yaml", HERE);

        assertThat(grid.width()).isEqualTo(4);
        assertThat(grid.originX()).isZero();
        assertThat(grid.cells())
                .containsExactly(
                        OCCUPIED, FREE, UNKNOWN, UNKNOWN, OCCUPIED, FREE, UNKNOWN, OCCUPIED, OCCUPIED, OCCUPIED,
                        OCCUPIED, OCCUPIED);
    }

    @Test
    void aDrawingWithAnotherLetterIsRefused() throws IOException {
        write("lab.yaml", "resolution: 0.5\ndrawing: |\n  ##\n  #x\n");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> maps.read("lab.yaml", HERE))
                .withMessageContaining("lab.yaml:2:10: 'drawing' has a 'x' in its line 2, column 2.");
    }

    @Test
    void theImageIsLookedForBesideTheYaml() throws IOException {
        Files.createDirectory(folder.resolve("maps"));
        write("maps/lab.yaml", LAB);
        write("maps/lab.pgm", "P2 1 1 1 0");
        assertThat(maps.read("maps/lab.yaml", HERE).cells()).containsExactly(OCCUPIED);
    }

    @Test
    void everyMapThatComesAlongCanBeRead() {
        assertThat(Maps.builtIn())
                .allSatisfy(name -> assertThat(maps.read(name, HERE).cells()).contains(FREE, OCCUPIED));
    }

    @Test
    void anUnknownMapIsRefusedWhereItIsNamed() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> maps.read("offise", HERE))
                .withMessageContaining("hunt.yaml:3:8: There is no map 'offise'.");
    }

    @Test
    void anImageAloneIsNoMap() {
        for (String name : List.of("lab.pgm", "maps/lab.PNG", "lab.pgm.gz")) {
            assertThatExceptionOfType(InvalidSettings.class)
                    .isThrownBy(() -> maps.read(name, HERE))
                    .withMessageContaining("'%s' is an image".formatted(name))
                    .withMessageContaining("YAML");
        }
    }

    @Test
    void aMissingImageIsReportedWhereTheYamlNamesIt() throws IOException {
        write("lab.yaml", LAB.replace("lab.pgm", "lob.pgm"));
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> maps.read("lab.yaml", HERE))
                .withMessageContaining("lab.yaml:1:8: There is no file 'lob.pgm'.");
    }

    @Test
    void anErrorIsReportedOnceAndByItsName() throws IOException {
        write("lab.yaml", LAB.replace("0.5", ".nan").replace("[-1, -2, 0]", "[.nan, -2, 0]"));
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> maps.read("lab.yaml", HERE))
                .satisfies(refused -> assertThat(refused.problems())
                        .extracting(problem -> problem.message())
                        .satisfiesExactly(
                                resolution -> assertThat(resolution).contains("'resolution'"),
                                origin -> assertThat(origin).contains("3 numbers; 'NaN' is not finite")));
        write("lab.yaml", LAB);
        write("lab.pgm", "P5\n0 0\n255\n");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> maps.read("lab.yaml", HERE))
                .withMessageContaining("nothing in it")
                .withMessageNotContaining("coarser");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "resolution: 0.5|resolution: 0",
                "resolution: 0.5|resolution: -0.05",
                "resolution: 0.5|resolution: 1e-300",
                "resolution: 0.5|resolutoin: 0.5",
                "[-1, -2, 0]|[-1, -2, 0.3]",
                "[-1, -2, 0]|[-1, -2]",
                "[-1, -2, 0]|[1e300, -2, 0]",
                "origin: [-1, -2, 0]|negate2: 0",
                "negate: 0|negate: 2",
                "negate: 0|mode: raw",
                "negate: 0|drawing: '#'",
                "image: lab.pgm|drawing: ''",
                "0.65|0.1",
                "0.65|1.5",
                "lab.pgm|../lab.pgm",
                "lab.pgm|/etc/passwd",
                "lab.pgm|lab.yaml",
                "lab.pgm|[1]"
            })
    void aWrongMapFileIsRefused(String change) throws IOException {
        String[] fromTo = change.split("\\|", 2);
        assertThat(LAB).contains(fromTo[0]);
        write("lab.yaml", LAB.replace(fromTo[0], fromTo[1]));
        assertThatExceptionOfType(InvalidSettings.class).isThrownBy(() -> maps.read("lab.yaml", HERE));
    }

    @Test
    void settingsOfOtherProgramsHaveNoEffectAndAreWarnedOf() throws IOException {
        write("lab.yaml", LAB + "lanes: {a: 1}\nfree_tresh: 0.1\n");
        assertThat(maps.find("lab.yaml", HERE).warnings())
                .extracting(Problem::toString)
                .containsExactly(
                        "lab.yaml:7:1: 'lanes' is not known here and has no effect.",
                        "lab.yaml:8:1: 'free_tresh' is not known here and has no effect.\n    Maybe 'free_thresh' was meant?");
        write("lab.yaml", LAB);
        assertThat(maps.find("lab.yaml", HERE).warnings()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            free_thresh: 0.196   | free_thresh: 0.25    | 6:14: 16.7 % of the image is gray 205, which map_saver writes for unknown space; 'free_thresh' makes it free.
            occupied_thresh: 0.65 | occupied_thresh: 0.196 | 5:18: 16.7 % of the image is gray 205, which map_saver writes for unknown space; 'occupied_thresh' makes it occupied.
            negate: 0            | negate: 1            | 4:9: 16.7 % of the image is gray 205, which map_saver writes for unknown space; 'negate' makes it occupied.
            """)
    void unknownSpaceThatIsReadAsSomethingElseIsWarnedOf(String from, String to, String warning) throws IOException {
        write("lab.pgm", PGM.replace("128", "205"));
        assertThat(maps.find("lab.yaml", HERE).warnings()).isEmpty();
        write("lab.yaml", LAB.replace(from, to));
        assertThat(maps.find("lab.yaml", HERE).warnings())
                .singleElement()
                .satisfies(problem -> assertThat(problem.toString()).startsWith("lab.yaml:" + warning));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "P",
                "P2",
                "P5 3 2 255",
                "P5 3 2 255 ab",
                "P2 3 2 255 0 1 2 3 4",
                "P2 3 2 255 0 1 2 3 4 x",
                "P2 0 2 255",
                "P2 -3 2 255",
                "P2 3 2 0 0 0 0 0 0 0",
                "P2 3 2 70000 0 0 0 0 0 0",
                "P2 1 1 5 6",
                "P2 99999999 99999999 255 0",
                "P2 99999999999999999999 1 255 0",
                "P5 16385 8192 255 ",
                "P2 # never ends",
                "P6 1 1 255 abc"
            })
    void aBrokenPgmIsRefused(String pgm) throws IOException {
        write("lab.pgm", pgm);
        assertThatExceptionOfType(InvalidSettings.class).isThrownBy(() -> maps.read("lab.yaml", HERE));
    }

    @Test
    void grayInAPngMeansTheSameAsInAPgm() throws IOException {
        var image = new BufferedImage(256, 1, BufferedImage.TYPE_BYTE_GRAY);
        for (int shade = 0; shade < 256; shade++) {
            image.getRaster().setSample(shade, 0, 0, shade);
        }
        ImageIO.write(image, "png", folder.resolve("lab.png").toFile());
        write("lab.yaml", LAB.replace("lab.pgm", "lab.png"));
        byte[] cells = maps.read("lab.yaml", HERE).cells();
        for (int shade = 0; shade < 256; shade++) {
            write("one.pgm", "P2 1 1 255 " + shade);
            write("one.yaml", LAB.replace("lab.pgm", "one.pgm"));
            assertThat(cells[shade])
                    .as("shade %d", shade)
                    .isEqualTo(maps.read("one.yaml", HERE).cells()[0]);
        }
    }

    @Test
    void aPngCutShortOrDamagedIsRefusedOrReadButNeverHurts() throws IOException {
        write("lab.yaml", LAB.replace("lab.pgm", "lab.png"));
        byte[] whole = png(0xff000000, 0xff808080, 0xffffffff, 0xffffffff, 0x80ffffff, 0xff000000);
        for (int length = 0; length < whole.length / 2; length++) {
            Files.write(folder.resolve("lab.png"), Arrays.copyOf(whole, length));
            assertThatExceptionOfType(InvalidSettings.class)
                    .as("cut to %d bytes", length)
                    .isThrownBy(() -> maps.read("lab.yaml", HERE));
        }
        var random = new Random(5);
        for (int round = 0; round < 300; round++) {
            byte[] damaged = whole.clone();
            for (int i = 0; i < 1 + random.nextInt(4); i++) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt();
            }
            Files.write(folder.resolve("lab.png"), damaged);
            try {
                maps.read("lab.yaml", HERE);
            } catch (InvalidSettings e) {
                assertThat(e).as("round %d", round).hasMessageContaining("image");
            }
        }
    }

    @Test
    void aPngThatClaimsToBeHugeIsRefusedBeforeItIsUnpacked() throws IOException {
        write("lab.yaml", LAB.replace("lab.pgm", "lab.png"));
        byte[] png = png(0, 0, 0, 0, 0, 0);
        png[16] = 0x7f; // the first byte of the width
        Files.write(folder.resolve("lab.png"), png);
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> maps.read("lab.yaml", HERE))
                .withMessageContaining("lab.png");
    }

    private static byte[] png(int... argb) throws IOException {
        var image = new BufferedImage(3, 2, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 3, 2, argb, 0, 3);
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private void write(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text);
    }

    private void write(String name, String header, int... bytes) throws IOException {
        var out = new ByteArrayOutputStream();
        out.write(header.getBytes(US_ASCII));
        for (int b : bytes) {
            out.write(b);
        }
        Files.write(folder.resolve(name), out.toByteArray());
    }
}
