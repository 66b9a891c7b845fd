package rsal.scenario.installed;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import rsal.map.KnownMaps;

/// What the runs of one process have in common, one after the other or at the same time: robot systems, device
/// drivers and the newest maps. They keep what depends on a map only, such as distances to walls and costs of cells.
/// So it is computed for the first run alone, and no result depends on it. Any thread may ask.
public final class Installation {
    private final KnownMaps maps = new KnownMaps();
    private final MapFacts mapFacts = new MapFacts();
    private @Nullable Catalog catalog;
    private @Nullable ClassLoader loader; // by which it was found

    public KnownMaps maps() {
        return maps;
    }

    /// What follows from these maps.
    public MapFacts mapFacts() {
        return mapFacts;
    }

    /// What is installed for the thread that asks, as its class loader finds it.
    public synchronized Catalog catalog() {
        ClassLoader asking = Thread.currentThread().getContextClassLoader();
        Catalog known = catalog;
        if (known == null || !Objects.equals(asking, loader)) {
            known = Catalog.installed();
            catalog = known;
            loader = asking;
        }
        return known;
    }
}
