package rsal.rtps;

import java.util.BitSet;
import java.util.stream.LongStream;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Submessage.DataFragments;

/// A sample in fragments, some of which are there.
final class FragmentedSample {
    private final int fragmentSize; // B
    private final byte[] payload;
    private final BitSet there = new BitSet(); // of fragments, from 0 on
    private ParameterList inlineQos = ParameterList.EMPTY;
    private long grown; // when a fragment came last [ns]

    FragmentedSample(DataFragments part) {
        fragmentSize = part.fragmentSize();
        payload = new byte[part.sampleSize()];
    }

    /// Fragments of another size, or of a sample of another size, are no parts of it.
    ///
    /// @param now [ns]
    void add(DataFragments part, long now) {
        if (part.fragmentSize() != fragmentSize || part.sampleSize() != payload.length) {
            return;
        }
        grown = now;
        if (!part.inlineQos().isEmpty()) { // which some send with the first fragment only
            inlineQos = part.inlineQos().copy();
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

    ParameterList inlineQos() {
        return inlineQos;
    }

    long grown() {
        return grown;
    }

    byte[] payload() {
        return payload;
    }

    int bytes() {
        return payload.length;
    }
}
