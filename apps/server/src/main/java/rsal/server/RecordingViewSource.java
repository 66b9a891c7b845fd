package rsal.server;

import org.jspecify.annotations.Nullable;

/// Shows a recording.
record RecordingViewSource(RecordedPast past) implements ViewSource {
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
