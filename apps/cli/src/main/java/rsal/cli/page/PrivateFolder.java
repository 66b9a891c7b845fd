package rsal.cli.page;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import java.util.Set;

/// A folder for temporary files of one user, which nobody else can make in this user's place: all may write beside
/// it, so one that is a link, has another owner or is open to others is refused. There is none on Windows, where
/// each user has a home.
final class PrivateFolder {
    private static final Set<PosixFilePermission> OWNERS = PosixFilePermissions.fromString("rwx------");

    private PrivateFolder() {}

    /// Of this user; empty where there is none, or where it is not to be trusted.
    static Optional<Path> existing() {
        return existing(temporary());
    }

    static Optional<Path> existing(Path parent) {
        try {
            if (!isPosix(parent)) {
                return Optional.empty();
            }
            Path folder = named(parent);
            return Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS) && isOwn(folder)
                    ? Optional.of(folder)
                    : Optional.empty();
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /// Makes it, unless it is there.
    ///
    /// @throws IOException if it can't be made, or is not this user's alone
    static Path make() throws IOException {
        return make(temporary());
    }

    static Path make(Path parent) throws IOException {
        if (!isPosix(parent)) {
            throw new IOException("'%s' has no private folders".formatted(parent));
        }
        Path folder = named(parent);
        try {
            Files.createDirectory(folder, PosixFilePermissions.asFileAttribute(OWNERS));
        } catch (FileAlreadyExistsException _) {
            // checked below
        }
        if (!isOwn(folder)) {
            throw new IOException("'%s' is not a folder of this user alone".formatted(folder));
        }
        return folder;
    }

    private static Path temporary() {
        return Path.of(System.getProperty("java.io.tmpdir"));
    }

    private static boolean isPosix(Path parent) {
        return parent.getFileSystem().supportedFileAttributeViews().contains("unix");
    }

    /// By the number of the user, as users of containers may have no name.
    private static Path named(Path parent) throws IOException {
        Path own = Files.createTempFile(parent, "rsal", "");
        try {
            return parent.resolve("rsal-" + Files.getAttribute(own, "unix:uid"));
        } finally {
            Files.delete(own);
        }
    }

    static boolean isOwn(Path folder) throws IOException {
        PosixFileAttributes found = Files.readAttributes(folder, PosixFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
        return found.isDirectory()
                && found.permissions().equals(OWNERS)
                && folder.endsWith("rsal-" + Files.getAttribute(folder, "unix:uid", LinkOption.NOFOLLOW_LINKS));
    }
}
