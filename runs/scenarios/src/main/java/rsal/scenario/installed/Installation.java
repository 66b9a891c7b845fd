package rsal.scenario.installed;

import org.jspecify.annotations.Nullable;
import rsal.map.KnownMaps;

/// What the runs of one scenario have in common, in the order of a sweep or at the same time: robot systems, device
/// drivers and maps. They keep what depends on a map only, such as distances to walls and costs of cells, so that
/// it is computed for the first run alone. No run comes out otherwise for it. Any thread may ask.
public final class Installation {
    private final KnownMaps maps = new KnownMaps();
    private @Nullable Catalog last;

    public KnownMaps maps() {
        return maps;
    }

    /// What is installed now.
    public synchronized Catalog catalog() {
        Catalog before = last;
        Catalog now = before == null ? Catalog.installed() : before.again();
        last = now;
        return now;
    }
}
