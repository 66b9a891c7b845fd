package rsal.navigation.amcl;

import java.util.Arrays;

/// Counts how many bins of the pose space are in use, and numbers them in the order in which they came into use:
/// a hash table of its own, so that nothing is allocated per particle. It grows when it has to.
final class PoseBins {
    static final int NONE = -1;

    private static final int FEW = 64; // bins that there is room for at first
    private static final int ROOM = 4; // places in the table for each of them; both powers of 2

    private final double binsPerMeter;
    private final int headings;
    private long[] keys;
    private int[] numbers;
    private int[] slots;
    private int count;

    /// @param meters side of a bin
    /// @param headings bins of a full turn
    PoseBins(double meters, int headings) {
        this.binsPerMeter = 1 / meters;
        this.headings = headings;
        this.keys = new long[ROOM * FEW];
        this.numbers = new int[ROOM * FEW];
        this.slots = new int[FEW];
        Arrays.fill(numbers, NONE);
    }

    private void grow() {
        long[] used = new long[count];
        for (int i = 0; i < count; i++) {
            used[i] = keys[slots[i]];
        }
        keys = new long[2 * keys.length];
        numbers = new int[keys.length];
        slots = new int[2 * slots.length];
        Arrays.fill(numbers, NONE);
        for (int i = 0; i < count; i++) {
            put(slot(used[i]), used[i], i);
        }
    }

    private void put(int slot, long key, int number) {
        keys[slot] = key;
        numbers[slot] = number;
        slots[number] = slot;
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
            if (count == slots.length) {
                grow();
                slot = slot(key);
            }
            put(slot, key, count++);
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
