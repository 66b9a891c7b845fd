package rsal.rtps;

/// How many bytes samples in fragments may take together until they are complete.
final class AssemblyBudget {
    private final RtpsLimits limits;
    private long used; // B

    AssemblyBudget(RtpsLimits limits) {
        this.limits = limits;
    }

    boolean take(int bytes) {
        if (bytes > limits.sample() || used + bytes > limits.assembly()) {
            return false;
        }
        used += bytes;
        return true;
    }

    void give(int bytes) {
        used -= bytes;
    }

    RtpsLimits limits() {
        return limits;
    }
}
