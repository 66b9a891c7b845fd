package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.LongTest;

/// The cache from which releases start fast.
class PrepareIT {
    @TempDir
    private Path folder;

    @Test
    @LongTest
    void makesACacheOnceFromWhichJavaStarts() throws Exception {
        Path cache = folder.resolve("inner").resolve("start.aot");
        Rsal rsal = new Rsal(folder).withPage().with("-Drsal.cache=" + cache);

        Ended made = rsal.run("prepare");

        assertThat(made.err()).isEmpty();
        assertThat(made.code()).isZero();
        assertThat(made.out().strip()).isEqualTo(cache.toString());
        assertThat(Files.size(cache)).isGreaterThan(1_000_000);
        var first = Files.getLastModifiedTime(cache);
        assertThat(rsal.run("prepare").code()).isZero();
        assertThat(Files.getLastModifiedTime(cache)).isEqualTo(first);
        Ended started =
                rsal.with("-XX:AOTCache=" + cache, "-XX:AOTMode=on").run("list"); // 'on' fails where it does not fit
        assertThat(started.code()).as(started.err()).isZero();
    }

    @Test
    void aFolderThatCantBeWrittenIsReported() throws Exception {
        Path file = Files.writeString(folder.resolve("file"), "no folder");

        Ended ended = new Rsal(folder)
                .withPage()
                .with("-Drsal.cache=" + file.resolve("start.aot"))
                .run("prepare");

        assertThat(ended.code()).isEqualTo(5);
        assertThat(ended.err()).contains("can't be written");
    }

    @Test
    void onlyAReleaseHasOne() throws Exception {
        Ended ended = new Rsal(folder).run("prepare");

        assertThat(ended.code()).isEqualTo(5);
        assertThat(ended.err()).contains("not an unpacked release");
    }

    /// Else each start would try again what can't be.
    @Test
    void whatJavaCantMakeIsNotTriedAgain() throws Exception {
        Path cache = folder.resolve("start.aot");
        Files.createFile(cache);

        Ended ended = new Rsal(folder)
                .with("-Drsal.cache=" + cache)
                .run("run", "--headless", "--speed", "max", "--for", "1", "--json");

        assertThat(ended.err()).isNotNull();
        assertThat(cache).isEmptyFile();
        assertThat(folder.resolve("start.aot.lock")).doesNotExist();
    }
}
