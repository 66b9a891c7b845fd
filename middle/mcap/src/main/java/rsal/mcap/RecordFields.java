package rsal.mcap;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/// Reads what a record holds, field by field, and never beyond its end.
final class RecordFields {
    private final ByteBuffer bytes;

    RecordFields(ByteBuffer bytes) {
        this.bytes = bytes.duplicate().order(ByteOrder.LITTLE_ENDIAN);
    }

    int remaining() {
        return bytes.remaining();
    }

    int u8() throws Malformed {
        need(1);
        return Byte.toUnsignedInt(bytes.get());
    }

    int u16() throws Malformed {
        need(2);
        return Short.toUnsignedInt(bytes.getShort());
    }

    int crc() throws Malformed {
        need(4);
        return bytes.getInt();
    }

    long u32() throws Malformed {
        return Integer.toUnsignedLong(crc());
    }

    long u64() throws Malformed {
        need(8);
        return bytes.getLong();
    }

    String string() throws Malformed {
        ByteBuffer part = part(u32());
        return StandardCharsets.UTF_8.decode(part).toString();
    }

    byte[] bytes() throws Malformed {
        ByteBuffer part = part(u32());
        byte[] copy = new byte[part.remaining()];
        part.get(copy);
        return copy;
    }

    Map<String, String> map() throws Malformed {
        var entries = new RecordFields(part(u32()));
        var map = new LinkedHashMap<String, String>();
        while (entries.remaining() > 0) {
            map.put(entries.string(), entries.string());
        }
        return map;
    }

    /// What follows, of a length; then goes on after it.
    RecordFields part() throws Malformed {
        return new RecordFields(part(u32()));
    }

    private ByteBuffer part(long length) throws Malformed {
        if (length < 0 || length > bytes.remaining()) {
            throw new Malformed("a field of %s bytes in %d".formatted(Long.toUnsignedString(length), remaining()));
        }
        ByteBuffer part = bytes.slice(bytes.position(), (int) length);
        bytes.position(bytes.position() + (int) length);
        return part;
    }

    private void need(int count) throws Malformed {
        if (bytes.remaining() < count) {
            throw new Malformed("it is too short");
        }
    }
}
