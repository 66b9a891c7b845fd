package rsal.experiment;

import java.util.List;
import java.util.stream.LongStream;

/// Seeds one after the other, both ends included.
public record SeedRange(long first, long last) {
    private static final long MOST = 1_000_000;

    public SeedRange {
        if (last < first || last - first < 0 || last - first >= MOST) {
            throw new IllegalArgumentException(
                    "Seeds %d:%d must go up, and be of at most %d seeds.".formatted(first, last, MOST));
        }
    }

    /// As typed: `101:120` as ranges of arguments are, `101-120`, or how many there are from 1 on, `20`.
    ///
    /// @throws IllegalArgumentException with a sentence about what is wrong with it
    public static SeedRange parse(String typed) {
        int colon = typed.indexOf(':');
        int between = colon >= 0 ? colon : typed.indexOf('-', 1); // seeds may be below 0
        if (between < 0) {
            long count = whole(typed);
            if (count < 1) {
                throw new IllegalArgumentException("'%s' is less than one seed.".formatted(typed.strip()));
            }
            return new SeedRange(1, count);
        }
        return new SeedRange(whole(typed.substring(0, between)), whole(typed.substring(between + 1)));
    }

    private static long whole(String typed) {
        try {
            return Long.parseLong(typed.strip());
        } catch (NumberFormatException _) {
            throw new IllegalArgumentException(
                    "'%s' is not a whole number, like 42. Maybe 20 seeds were meant (20), or those from 101 to 120 (101:120)?"
                            .formatted(typed.strip()));
        }
    }

    public List<Long> seeds() {
        return LongStream.rangeClosed(first, last).boxed().toList();
    }
}
