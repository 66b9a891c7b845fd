package rsal.agent;

import java.util.Optional;

/// Code of an agent that runs in another process, for those who look whether the agent never returns. May be asked on
/// any thread.
public interface OutsideCode {
    /// Where that code is now, for people: `hunter.py:42 in on_scan`; empty when nobody knows.
    Optional<String> place();

    /// Whether somebody looks into it with a debugger, so that it may take as long as that needs.
    boolean isDebugged();

    /// Ends that code at once, as it never returns: else it would go on when the run is over.
    void kill();
}
