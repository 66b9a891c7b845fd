package rsal.rtps.wire;

import java.nio.ByteBuffer;

/// Names a participant, writer or reader on the network.
public record Guid(GuidPrefix prefix, EntityId entity) {
    public static final int BYTES = GuidPrefix.BYTES + EntityId.BYTES;

    public static Guid read(ByteBuffer bytes) {
        return new Guid(GuidPrefix.read(bytes), EntityId.read(bytes));
    }

    public void write(ByteBuffer bytes) {
        prefix.write(bytes);
        entity.write(bytes);
    }

    @Override
    public String toString() {
        return prefix + ":" + entity;
    }
}
