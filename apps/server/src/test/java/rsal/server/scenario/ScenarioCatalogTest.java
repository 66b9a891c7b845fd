package rsal.server.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.server.message.Messages.HostInfo;
import rsal.server.message.Messages.ScenarioInfo;
import rsal.server.message.Refusal;

class ScenarioCatalogTest {
    private static final int HUNTER = 0xff0072b2;
    private static final String TEXT = """
            rsal: 1
            scenario: mine
            title: My own
            world: {map: office}
            robots: {one: {model: pioneer2dx, pose: [0, 0, 0]}}
            """;

    @TempDir
    Path folder;

    @Test
    void offersWhatWasNamed() throws IOException {
        Path own = Files.writeString(folder.resolve("own.yaml"), TEXT);
        var catalog = new ScenarioCatalog(List.of(own.toString(), "hunt-and-prey"));

        assertThat(catalog.all().scenarios())
                .extracting(ScenarioInfo::id)
                .containsExactly(own.toString(), "hunt-and-prey");
        assertThat(catalog.all().scenarios()).extracting(ScenarioInfo::problem).containsOnly("");
        assertThat(catalog.all().hosts()).extracting(HostInfo::key).contains("plain");
    }

    @Test
    void readsFilesAnewAndReportsWhatIsWrongWithThem() throws IOException {
        Path own = Files.writeString(folder.resolve("own.yaml"), TEXT);
        var catalog = new ScenarioCatalog(List.of(own.toString(), "hunt-and-prey"));
        byte[] first = catalog.picture(own.toString());
        assertThat(catalog.picture(own.toString())).isSameAs(first);
        Files.writeString(own, TEXT.replace("My own", "Mine, mended"));
        assertThat(catalog.all().scenarios().getFirst().title()).isEqualTo("Mine, mended");

        Files.writeString(own, TEXT.replace("pioneer2dx", "pioneer9")); // which is found once it is to be run
        assertThat(own.toFile().setLastModified(own.toFile().lastModified() + 10_000))
                .isTrue();
        assertThatThrownBy(() -> catalog.picture(own.toString())).isInstanceOf(Refusal.class);

        Files.writeString(own, TEXT.replace("rsal: 1", "rsal: 7"));
        assertThat(catalog.all().scenarios().getFirst().problem()).contains("own.yaml", "'7");

        Files.delete(own);
        assertThat(catalog.all().scenarios().getFirst().problem()).isNotEmpty();
        assertThat(catalog.all().scenarios().getLast().problem()).isEmpty();
    }

    @Test
    void drawsTheScenarioOfAFolderAnewWhenItsFileHasChanged() throws IOException {
        Path own = Files.createDirectory(folder.resolve("own"));
        File file = Files.writeString(own.resolve("own.yaml"), TEXT).toFile();
        long whenFolderChanged = own.toFile().lastModified();
        var catalog = new ScenarioCatalog(List.of(own.toString()));
        assertThat(catalog.picture(own.toString())).isNotEmpty();

        Files.writeString(file.toPath(), TEXT.replace("pioneer2dx", "pioneer9"));
        assertThat(file.setLastModified(file.lastModified() + 10_000)).isTrue();
        assertThat(own.toFile().lastModified()).isEqualTo(whenFolderChanged);
        assertThatThrownBy(() -> catalog.picture(own.toString())).isInstanceOf(Refusal.class);
    }

    @Test
    void drawsHowTheyBegin() throws IOException {
        byte[] png = new ScenarioCatalog(List.of("hunt-and-prey")).picture("hunt-and-prey");

        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png));
        assertThat(picture.getWidth()).isEqualTo(640);
        int[] pixels = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
        assertThat(IntStream.of(pixels).filter(argb -> argb == HUNTER)).isNotEmpty();
    }
}
