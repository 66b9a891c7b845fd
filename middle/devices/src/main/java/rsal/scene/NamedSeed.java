package rsal.scene;

/// Seeds of what is left to chance in a world, each from a seed and a name, so that one more changes no other. The
/// same worlds have been made with the formula ever since.
public final class NamedSeed {
    private NamedSeed() {}

    public static long of(long seed, String name) {
        return 31 * seed + name.hashCode();
    }
}
