package rsal.player.bridge;

import org.jspecify.annotations.Nullable;

/// Which of a robot's devices its clients drive it by: the one they commanded last, so that no two of them pull.
final class ExclusiveControl {
    private @Nullable Holder holder;

    interface Holder {
        /// Drives no more: another does.
        void letGo();
    }

    void take(Holder next) {
        Holder before = holder;
        holder = next;
        if (before != null && !before.equals(next)) {
            before.letGo();
        }
    }
}
