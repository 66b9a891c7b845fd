package rsal.navigation.amcl;

import java.util.Arrays;

/// Counts how many bins of the pose space are in use, and numbers them in the order in which they came into use:
/// a hash table of its own, so that nothing is allocated per particle.
final class PoseBins {
    static final int NONE = -1;

    private final double binsPerMeter;
    private final int headings;
    private final long[] keys;
    private final int[] numbers;
    private final int[] slots;
    private int count;

    /// @param meters side of a bin
    /// @param headings bins of a full turn
    /// @param capacity most bins that can be in use
    PoseBins(double meters, int headings, int capacity) {
        this.binsPerMeter = 1 / meters;
        this.headings = headings;
        int size = Integer.highestOneBit(Math.max(16, capacity)) * 4;
        this.keys = new long[size];
        this.numbers = new int[size];
        this.slots = new int[capacity];
        Arrays.fill(numbers, NONE);
    }

    int count() {
        return count;
    }

    void clear() {
        for (int i = 0; i < count; i++) {
            numbers[slots[i]] = NONE;
        }
        count = 0;
    }

    /// The number of a pose's bin, which from now on is in use.
    int add(double x, double y, double theta) {
        int heading = (int) ((theta + Math.PI) / (2 * Math.PI) * headings);
        long key = key(
                (int) Math.floor(x * binsPerMeter),
                (int) Math.floor(y * binsPerMeter),
                Math.min(heading, headings - 1));
        int slot = slot(key);
        if (numbers[slot] == NONE) {
            keys[slot] = key;
            numbers[slot] = count;
            slots[count++] = slot;
        }
        return numbers[slot];
    }

    /// The number of the bin so many bins away from another one; [#NONE] when it is not in use.
    int neighbor(int number, int dx, int dy, int dHeading) {
        long key = keys[slots[number]];
        int x = (int) (key >> 40);
        int y = (int) (key << 24 >> 40);
        int heading = (int) (key & 0xFFFF);
        return numbers[slot(key(x + dx, y + dy, Math.floorMod(heading + dHeading, headings)))];
    }

    private static long key(int x, int y, int heading) {
        return (long) x << 40 | (y & 0xFFFFFFL) << 16 | heading;
    }

    private int slot(long key) {
        int mask = keys.length - 1;
        long mixed = key * 0x9E3779B97F4A7C15L; // the golden ratio spreads neighbors (Knuth, TAOCP 3, 6.4)
        int slot = (int) (mixed >>> 32) & mask;
        while (numbers[slot] != NONE && keys[slot] != key) {
            slot = slot + 1 & mask;
        }
        return slot;
    }
}
