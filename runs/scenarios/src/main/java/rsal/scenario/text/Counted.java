package rsal.scenario.text;

/// Numbers of things in words for people.
public final class Counted {
    private Counted() {}

    /// `3 runs`, `1 run`.
    ///
    /// @param what one of them, of which more have an s
    public static String of(long count, String what) {
        return "%d %s%s".formatted(count, what, count == 1 ? "" : "s");
    }
}
