package rsal.server;

import org.jspecify.annotations.Nullable;

/// Shows a recording.
record RecordingShowing(RecordedPast past) implements Showing {
    @Override
    public void look(int pause) {} // it stays as it is

    @Override
    public @Nullable Feed live() {
        return null;
    }

    @Override
    public boolean isFast() {
        return false;
    }
}
