package rsal.testkit;

/// How often a test tries something: each landing tries less than `./rsal test --all`.
public final class Rounds {
    private Rounds() {}

    /// @param landing how often each landing tries it
    /// @param all how often `./rsal test --all` does
    public static int of(int landing, int all) {
        return Boolean.getBoolean(LongTest.PROPERTY) ? all : landing;
    }
}
