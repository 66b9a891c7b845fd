package rsal.server.access;

/// What somebody may do here, each role more than the one before.
public enum Role {
    /// Look at runs.
    WATCH,

    /// Drive robots, control and restart runs.
    OPERATE,

    /// Also write scenarios, which may name programs, and run sweeps.
    ADMIN;

    /// Whether it may do all that the other one may.
    public boolean includes(Role other) {
        return compareTo(other) >= 0;
    }
}
