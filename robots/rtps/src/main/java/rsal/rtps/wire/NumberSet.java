package rsal.rtps.wire;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.stream.LongStream;

/// Some of up to 256 numbers from a base on: sequence numbers, or those of fragments (DDSI-RTPS 2.5, 9.4.2.6 and
/// 9.4.2.8).
public final class NumberSet {
    /// How many numbers from the base on it can tell of.
    public static final int MOST = 256;

    private final long base;
    private final int size;
    private final int[] words; // bit i is the bit 31 - i % 32 of word i / 32

    private NumberSet(long base, int size, int[] words) {
        this.base = base;
        this.size = size;
        this.words = words;
    }

    /// @param numbers ascending, none below the base; those from base + 256 on are left out
    public static NumberSet of(long base, LongStream numbers) {
        var words = new int[MOST / Integer.SIZE];
        int size = 0;
        for (long number : numbers.takeWhile(each -> each < base + MOST).toArray()) {
            int bit = (int) (number - base);
            words[bit / Integer.SIZE] |= Integer.MIN_VALUE >>> bit % Integer.SIZE;
            size = bit + 1;
        }
        return new NumberSet(base, size, Arrays.copyOf(words, words(size)));
    }

    public static NumberSet empty(long base) {
        return new NumberSet(base, 0, new int[0]);
    }

    static NumberSet readNumbers(ByteBuffer bytes) throws InvalidRtps {
        return readBits(SequenceNumber.read(bytes), bytes);
    }

    static NumberSet readFragments(ByteBuffer bytes) throws InvalidRtps {
        return readBits(bytes.getInt() & 0xffff_ffffL, bytes);
    }

    private static NumberSet readBits(long base, ByteBuffer bytes) throws InvalidRtps {
        int size = bytes.getInt();
        if (size < 0 || size > MOST) {
            throw new InvalidRtps("A set of %d numbers; the most are %d.".formatted(size & 0xffff_ffffL, MOST));
        }
        var words = new int[words(size)];
        for (int i = 0; i < words.length; i++) {
            words[i] = bytes.getInt();
        }
        return new NumberSet(base, size, words);
    }

    void writeNumbers(ByteBuffer bytes) {
        SequenceNumber.write(bytes, base);
        writeBits(bytes);
    }

    void writeFragments(ByteBuffer bytes) {
        bytes.putInt((int) base);
        writeBits(bytes);
    }

    private void writeBits(ByteBuffer bytes) {
        bytes.putInt(size);
        for (int word : words) {
            bytes.putInt(word);
        }
    }

    private static int words(int size) {
        return (size + Integer.SIZE - 1) / Integer.SIZE;
    }

    public long base() {
        return base;
    }

    public boolean isEmpty() {
        return numbers().findAny().isEmpty();
    }

    /// Those that are in it, ascending.
    public LongStream numbers() {
        return LongStream.range(0, size)
                .filter(bit -> (words[(int) bit / Integer.SIZE] & Integer.MIN_VALUE >>> (int) bit % Integer.SIZE) != 0)
                .map(bit -> base + bit);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof NumberSet set
                && base == set.base
                && Arrays.equals(numbers().toArray(), set.numbers().toArray());
    }

    @Override
    public int hashCode() {
        return Long.hashCode(base) * 31 + Arrays.hashCode(numbers().toArray());
    }

    @Override
    public String toString() {
        return base + Arrays.toString(numbers().toArray());
    }
}
