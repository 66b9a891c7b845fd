package rsal.rtps;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/// What is due to other participants, gathered by addressee, so that all for one of them goes in one datagram
/// ([DatagramOutbox]).
final class DueParts {
    private final Map<Addressee, List<Runnable>> parts = new LinkedHashMap<>();

    /// @param part writes to the outbox, for this addressee
    void add(Addressee addressee, Runnable part) {
        parts.computeIfAbsent(addressee, _ -> new ArrayList<>(1)).add(part);
    }

    void write() {
        parts.values().forEach(all -> all.forEach(Runnable::run));
    }
}
