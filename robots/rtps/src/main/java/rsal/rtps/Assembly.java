package rsal.rtps;

import java.util.BitSet;
import java.util.stream.LongStream;
import rsal.rtps.wire.Submessage.DataFragments;

/// A sample in fragments, some of which are there.
final class Assembly {
    private final int fragmentSize; // B
    private final byte[] payload;
    private final BitSet there = new BitSet(); // of fragments, from 0 on

    Assembly(DataFragments part) {
        fragmentSize = part.fragmentSize();
        payload = new byte[part.sampleSize()];
    }

    /// Fragments of another size, or of a sample of another size, are no parts of it.
    void add(DataFragments part) {
        if (part.fragmentSize() != fragmentSize || part.sampleSize() != payload.length) {
            return;
        }
        int begin = (part.first() - 1) * fragmentSize;
        int length = Math.min(part.count() * fragmentSize, payload.length - begin);
        part.part().get(part.part().position(), payload, begin, length);
        there.set(part.first() - 1, part.first() - 1 + part.count());
    }

    boolean isComplete() {
        return there.cardinality() == count();
    }

    private int count() {
        return (payload.length + fragmentSize - 1) / fragmentSize;
    }

    /// Numbers of the fragments that are missing, from 1 on.
    LongStream missing() {
        return LongStream.range(0, count())
                .filter(each -> !there.get((int) each))
                .map(each -> each + 1);
    }

    byte[] payload() {
        return payload;
    }

    int bytes() {
        return payload.length;
    }
}
