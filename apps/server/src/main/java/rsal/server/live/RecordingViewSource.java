package rsal.server.live;

import org.jspecify.annotations.Nullable;
import rsal.server.frame.Feed;
import rsal.server.history.RecordedPast;

/// Shows a recording.
public record RecordingViewSource(RecordedPast past) implements ViewSource {
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
