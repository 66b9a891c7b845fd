package rsal.release;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.Map;
import java.util.zip.Deflater;
import org.apache.commons.compress.archivers.tar.TarArchiveEntry;
import org.apache.commons.compress.archivers.tar.TarArchiveOutputStream;
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry;
import org.apache.commons.compress.archivers.zip.ZipArchiveOutputStream;
import org.apache.commons.compress.compressors.gzip.GzipCompressorOutputStream;
import org.apache.commons.compress.compressors.gzip.GzipParameters;

/// Packs files so that the same files give the same bytes: in sorted order, with one time, and with nobody's name.
enum Archive {
    TAR_GZ(".tar.gz") {
        @Override
        void write(FileTree tree, String top, OutputStream out) throws IOException {
            var gzip = new GzipParameters();
            gzip.setCompressionLevel(Deflater.BEST_COMPRESSION);
            gzip.setModificationInstant(Instant.EPOCH); // 'no time'
            try (var tar = new TarArchiveOutputStream(new GzipCompressorOutputStream(out, gzip))) {
                tar.setLongFileMode(TarArchiveOutputStream.LONGFILE_POSIX);
                for (Map.Entry<String, FileTree.Content> file : tree.files().entrySet()) {
                    byte[] bytes = file.getValue().source().bytes();
                    var entry = new TarArchiveEntry(top + "/" + file.getKey());
                    entry.setSize(bytes.length);
                    entry.setModTime(TIME.toEpochMilli());
                    entry.setMode(mode(file.getValue()));
                    entry.setIds(0, 0);
                    entry.setNames("", "");
                    tar.putArchiveEntry(entry);
                    tar.write(bytes);
                    tar.closeArchiveEntry();
                }
            }
        }
    },
    ZIP(".zip") {
        @Override
        void write(FileTree tree, String top, OutputStream out) throws IOException {
            try (var zip = new ZipArchiveOutputStream(out)) {
                zip.setLevel(Deflater.BEST_COMPRESSION);
                for (Map.Entry<String, FileTree.Content> file : tree.files().entrySet()) {
                    var entry = new ZipArchiveEntry(top + "/" + file.getKey());
                    entry.setTimeLocal(LocalDateTime.ofInstant(TIME, ZoneOffset.UTC)); // ZIP has no zones
                    entry.setUnixMode(mode(file.getValue()));
                    zip.putArchiveEntry(entry);
                    zip.write(file.getValue().source().bytes());
                    zip.closeArchiveEntry();
                }
            }
        }
    };

    /// Of all files: that of `project.build.outputTimestamp`, which jars have inside, too.
    private static final Instant TIME = Instant.parse("2026-01-01T00:00:00Z");

    private final String suffix;

    Archive(String suffix) {
        this.suffix = suffix;
    }

    /// The one that people of a system can open without a further program.
    static Archive of(TargetSystem system) {
        return system.isWindows() ? ZIP : TAR_GZ;
    }

    String suffix() {
        return suffix;
    }

    /// @param top the one folder that all files lie in
    abstract void write(FileTree tree, String top, OutputStream out) throws IOException;

    /// Writes a whole file or, when that fails, none.
    void write(FileTree tree, String top, Path file) throws IOException {
        Path fresh = file.resolveSibling(file.getFileName() + ".new");
        try {
            try (var out = new BufferedOutputStream(Files.newOutputStream(fresh))) {
                write(tree, top, out);
            }
            Files.move(fresh, file, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }

    private static int mode(FileTree.Content content) {
        return content.executable() ? 0755 : 0644;
    }
}
