package rsal.sim;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/// Random streams, one for each name, all from one seed.
record RandomStreams(long seed) {
    private static final long FNV_PRIME = 0x100000001b3L; // Fowler, Noll, Vo: FNV-1a, 64 bits
    private static final long FNV_BASIS = 0xcbf29ce484222325L;

    RandomGenerator stream(String name) {
        long hash = FNV_BASIS ^ seed;
        for (int i = 0; i < name.length(); i++) {
            hash = (hash ^ name.charAt(i)) * FNV_PRIME;
        }
        return new SplittableRandom(hash);
    }
}
