package rsal.cli.terminal;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/// Where results go. Remembers why they could not be written, which every `PrintWriter` keeps to itself.
public final class Stdout extends FilterOutputStream {
    private @Nullable IOException failure;

    public Stdout() {
        this(new FileOutputStream(FileDescriptor.out));
    }

    public Stdout(OutputStream out) {
        super(out);
    }

    @Override
    public void write(int octet) throws IOException {
        write(new byte[] {(byte) octet}, 0, 1);
    }

    @Override
    public void write(byte[] octets, int from, int count) throws IOException {
        try {
            out.write(octets, from, count);
        } catch (IOException e) {
            failure = e;
            throw e;
        }
    }

    /// Why a result is not where it should be, such as a full disk. A reader that has seen enough (`| head`) is no
    /// reason.
    public Optional<IOException> failure() {
        return Optional.ofNullable(failure).filter(e -> !"Broken pipe".equals(e.getMessage()));
    }
}
