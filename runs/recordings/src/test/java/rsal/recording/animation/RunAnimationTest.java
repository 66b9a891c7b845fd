package rsal.recording.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.metadata.IIOMetadataNode;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.engine.report.RobotView;
import rsal.recording.Playback;
import rsal.recording.Recorded;
import rsal.recording.Recording;

class RunAnimationTest {
    private static final int SECONDS = 6;
    private static final int LONGEST = 600; // px

    @TempDir
    static Path folder;

    private static Playback playback;

    @BeforeAll
    static void record() throws Exception {
        Path file = folder.resolve("hunt.mcap");
        Recorded.run(Recorded.plan("hunt-and-prey", 7, SECONDS), file);
        playback = Playback.of(Recording.open(file.toString(), false));
    }

    @AfterAll
    static void close() throws IOException {
        playback.close();
    }

    private static RunAnimation.Settings settings(double speed, double fps, double from, double until) {
        return new RunAnimation.Settings(
                LONGEST,
                speed,
                fps,
                Duration.ofMillis(Math.round(1e3 * from)),
                Duration.ofMillis(Math.round(1e3 * until)));
    }

    /// @param shown of each frame [1/100 s]
    private record Gif(List<BufferedImage> frames, List<Integer> shown, boolean endless) {
        static Gif read(byte[] bytes) throws IOException {
            var reader = ImageIO.getImageReadersByFormatName("gif").next();
            reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(bytes)));
            var frames = new ArrayList<BufferedImage>();
            var shown = new ArrayList<Integer>();
            boolean endless = false;
            for (int i = 0; i < reader.getNumImages(true); i++) {
                var part = reader.read(i);
                var tree = (IIOMetadataNode) reader.getImageMetadata(i).getAsTree("javax_imageio_gif_image_1.0");
                var place = (IIOMetadataNode)
                        tree.getElementsByTagName("ImageDescriptor").item(0);
                var control = (IIOMetadataNode)
                        tree.getElementsByTagName("GraphicControlExtension").item(0);
                endless |= tree.getElementsByTagName("ApplicationExtension").getLength() > 0;
                shown.add(Integer.parseInt(control.getAttribute("delayTime")));
                BufferedImage before = i == 0 ? part : frames.getLast();
                var whole = new BufferedImage(before.getWidth(), before.getHeight(), BufferedImage.TYPE_INT_RGB);
                var graphics = whole.createGraphics();
                graphics.drawImage(before, 0, 0, null);
                graphics.drawImage(
                        part,
                        Integer.parseInt(place.getAttribute("imageLeftPosition")),
                        Integer.parseInt(place.getAttribute("imageTopPosition")),
                        null);
                graphics.dispose();
                frames.add(whole);
            }
            return new Gif(frames, shown, endless);
        }
    }

    @Test
    void showsRobotsInTheirColorsWhereTheyWere() throws IOException {
        Gif gif = Gif.read(new RunAnimation(playback, settings(2, 4, 0, 100)).gif(_ -> {}));
        OccupancyGrid map = playback.plan().map();
        double perMeter = LONGEST / (map.width() * map.resolution());
        for (int i = 0; i < gif.frames.size(); i++) {
            BufferedImage frame = gif.frames.get(i);
            Duration time = i == gif.frames.size() - 1
                    ? playback.until()
                    : playback.from().plusMillis(500L * i);
            for (RobotView robot : playback.at(time).robots()) {
                Pose2d pose = robot.truth().orElseThrow();
                int x = (int) ((pose.compose(new Pose2d(-0.35, 0, 0)).x() - map.originX()) * perMeter);
                int y = (int) ((map.originY()
                                + map.height() * map.resolution()
                                - pose.compose(new Pose2d(-0.35, 0, 0)).y())
                        * perMeter);
                Rgb color = Rgb.parse(robot.color()).orElseThrow();
                assertThat(off(frame.getRGB(x, y), color.packed()))
                        .as("%s in frame %d", robot.id(), i)
                        .isLessThan(60);
            }
        }
    }

    private static double off(int one, int other) {
        int red = (one >> 16 & 0xff) - (other >> 16 & 0xff);
        int green = (one >> 8 & 0xff) - (other >> 8 & 0xff);
        int blue = (one & 0xff) - (other & 0xff);
        return Math.sqrt(red * red + green * green + blue * blue);
    }

    /// As a whole picture each time: what is written of each is what has changed.
    @Test
    void eachFrameIsThePictureOfItsTime() throws IOException {
        Gif gif = Gif.read(new RunAnimation(playback, settings(2, 4, 1, 4)).gif(_ -> {}));
        var painter = new RunPainter(playback, LONGEST);
        for (int i = 0; i < gif.frames.size(); i++) {
            BufferedImage right = painter.paint(Duration.ofSeconds(1).plusMillis(500L * i));
            double sum = 0;
            for (int y = 0; y < right.getHeight(); y++) {
                for (int x = 0; x < right.getWidth(); x++) {
                    sum += off(gif.frames.get(i).getRGB(x, y), right.getRGB(x, y));
                }
            }
            assertThat(sum / right.getWidth() / right.getHeight())
                    .as("frame %d", i)
                    .isLessThan(1);
        }
    }

    @Test
    void isPlayedAsFastAsItIsAskedToAndBeginsAgain() throws IOException {
        var animation = new RunAnimation(playback, settings(3, 5, 0, 100));
        Gif gif = Gif.read(animation.gif(_ -> {}));
        int frames =
                (int) Math.ceil((playback.until().toMillis() - playback.from().toMillis()) / 600.0) + 1;
        assertThat(gif.frames).hasSize(frames);
        assertThat(animation.frames()).isEqualTo(frames);
        assertThat(gif.shown.subList(0, frames - 1)).containsOnly(20);
        assertThat(gif.shown.getLast()).isEqualTo(200);
        assertThat(gif.endless).isTrue();
        assertThat(gif.frames.getFirst().getWidth()).isEqualTo(LONGEST);
    }

    @Test
    void isTheSameEachTimeAndReportsHowFarItIs() throws IOException {
        var done = new ArrayList<Double>();
        byte[] gif = new RunAnimation(playback, settings(8, 2, 0, 100)).gif(done::add);
        assertThat(new RunAnimation(playback, settings(8, 2, 0, 100)).gif(_ -> {}))
                .isEqualTo(gif);
        assertThat(done).isSorted().endsWith(1.0);
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            value = {
                "99, 4, 10, 0, 9, `pixels, not '99'`",
                "800, 0, 10, 0, 9, `more than 0, not '0.0'`",
                "800, 4, 51, 0, 9, `frames a second, not '51.0'`",
                "800, 4, 0.5, 0, 9, `frames a second, not '0.5'`",
                "800, 4, 10, 5, 5, `after the beginning`"
            })
    void refusesWhatCannotBe(int longest, double speed, double fps, int from, int until, String why) {
        assertThatThrownBy(() -> new RunAnimation.Settings(
                        longest, speed, fps, Duration.ofSeconds(from), Duration.ofSeconds(until)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(why.replace("`", ""));
    }

    @Test
    void saysWhatWasRecordedWhenNothingWas() {
        assertThatThrownBy(() -> new RunAnimation(playback, settings(4, 10, 50, 60)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(" s to 6.0 s");
        assertThatThrownBy(() -> new RunAnimation(playback, settings(0.01, 50, 0, 60)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("more than 2000");
    }
}
