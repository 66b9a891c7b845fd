package rsal.server.live;

import org.jspecify.annotations.Nullable;
import rsal.server.frame.Feed;
import rsal.server.history.Past;

/// What there is to be shown. For one thread.
interface ViewSource {
    /// Sees what is new. To be called before all else.
    ///
    /// @param pause from this look to the next: 1 for each frame of a watched run
    void look(int pause);

    /// What is now; null of a recording, which has only been.
    @Nullable
    Feed live();

    Past past();

    /// Whether what is now goes by so fast that it can't be followed.
    boolean isFast();
}
