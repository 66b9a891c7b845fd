package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.function.IntConsumer;

/// Cells in the order of what they cost, each with a quarter turn: R. Dial's buckets (Algorithm 360, CACM 12, 1969).
/// All that wait at a time cost less than [#COUNT] more than the cheapest of them. Not safe for several threads at
/// once.
final class BucketQueue {
    /// A power of 2.
    static final int COUNT = 2048;

    private static final int ROOM = 16; // of a bucket at first

    private final int[][] entries = new int[COUNT][ROOM];
    private final int[] counts = new int[COUNT];

    void push(int value, int cell, int quarter) {
        int bucket = bucket(value);
        int count = counts[bucket];
        if (count == entries[bucket].length) {
            entries[bucket] = Arrays.copyOf(entries[bucket], 2 * count);
        }
        entries[bucket][count] = (cell << 2) | quarter;
        counts[bucket] = count + 1;
    }

    int count(int value) {
        return counts[bucket(value)];
    }

    boolean isEmpty(int value) {
        return count(value) == 0;
    }

    /// Whether none waits.
    boolean isEmpty() {
        for (int count : counts) {
            if (count > 0) {
                return false;
            }
        }
        return true;
    }

    int[] entries(int value) {
        return entries[bucket(value)];
    }

    void empty(int value) {
        counts[bucket(value)] = 0;
    }

    void clear() {
        Arrays.fill(counts, 0);
    }

    void forEach(IntConsumer cells) {
        for (int bucket = 0; bucket < COUNT; bucket++) {
            for (int i = 0; i < counts[bucket]; i++) {
                cells.accept(cell(entries[bucket][i]));
            }
        }
    }

    static int cell(int entry) {
        return entry >> 2;
    }

    static int quarter(int entry) {
        return entry & 3;
    }

    private static int bucket(int value) {
        return value & (COUNT - 1);
    }
}
