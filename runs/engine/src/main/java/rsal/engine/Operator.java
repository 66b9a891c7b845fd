package rsal.engine;

/// Who it is that tells runs something: one of several who may. Runs say so in their events of the kind `operator`.
public final class Operator {
    private static final ScopedValue<String> NAME = ScopedValue.newInstance();

    private Operator() {}

    /// What is told runs in some work, on this thread, is told by somebody.
    ///
    /// @param name for people; empty when it is not known
    /// @param work that may throw
    public static <X extends Throwable> void tells(String name, ScopedValue.CallableOp<?, X> work) throws X {
        var _ = ScopedValue.where(NAME, name).call(work);
    }

    /// Who tells something on this thread; empty when nobody knows.
    public static String name() {
        return NAME.orElse("");
    }
}
