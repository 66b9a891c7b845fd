package rsal.navigation.log;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;

/// Lines of a log that is a text, packed with gzip or not, read one at a time and none of them without bound.
public final class LogLines {
    private static final int LONGEST = 1 << 20; // bytes; 100,000 readings

    private final String file;
    private final InputStream in;
    private final byte[] block = new byte[1 << 16];
    private int blockEnd;
    private int next;
    private byte[] line = new byte[1 << 12];
    private int number;
    private boolean cutShort;

    /// @param file its name, for messages
    /// @param raw the file as it is; the caller closes it
    /// @throws BrokenLog when it is packed and damaged at its start
    /// @throws IOException when it can't be read
    public LogLines(String file, InputStream raw) throws IOException {
        this.file = file;
        var buffered = new BufferedInputStream(raw, 1 << 16);
        buffered.mark(2);
        boolean packed = buffered.read() == 0x1f && buffered.read() == 0x8b;
        buffered.reset();
        try {
            this.in = packed ? new GZIPInputStream(buffered, 1 << 16) : buffered;
        } catch (EOFException | ZipException e) {
            throw new BrokenLog(file, 0, "The file ends, or is damaged, within the head that gzip writes.", e);
        }
    }

    /// Number of the line read last, from 1.
    public int number() {
        return number;
    }

    /// Whether the line read last is the file's last and has no end.
    public boolean cutShort() {
        return cutShort;
    }

    /// The next line without its end, its characters those of ISO 8859-1; none at the end of the file.
    ///
    /// @throws BrokenLog when a packed file is cut short or damaged, or a line has more than a million characters
    /// @throws IOException when the file can't be read
    public Optional<String> read() throws IOException {
        int length = 0;
        while (true) {
            if (next == blockEnd && !fill()) {
                cutShort = length > 0;
                if (length == 0) {
                    return Optional.empty();
                }
                break;
            }
            int end = next;
            while (end < blockEnd && block[end] != '\n') {
                end++;
            }
            int more = end - next;
            if (length + more > LONGEST) {
                throw new BrokenLog(
                        file,
                        number + 1,
                        "The line has more than %d characters. Maybe this is not a log.".formatted(LONGEST));
            }
            if (length + more > line.length) {
                line = Arrays.copyOf(line, Math.max(2 * line.length, length + more));
            }
            System.arraycopy(block, next, line, length, more);
            length += more;
            next = end;
            if (next < blockEnd) {
                next++; // the line's end
                break;
            }
        }
        number++;
        return Optional.of(new String(line, 0, length, StandardCharsets.ISO_8859_1));
    }

    private boolean fill() throws IOException {
        try {
            blockEnd = Math.max(0, in.read(block));
        } catch (EOFException e) {
            throw new BrokenLog(
                    file, number, "The packed file ends early. Maybe it was cut short on its way; fetch it again.", e);
        } catch (ZipException e) {
            throw new BrokenLog(
                    file, number, "The packed file is damaged here (%s). Fetch it again.".formatted(e.getMessage()), e);
        }
        next = 0;
        return blockEnd > 0;
    }
}
