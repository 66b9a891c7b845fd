package rsal.navigation.grid;

import java.util.ArrayList;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.ScanMapper.PosedScan;

/// A map that is drawn again and again while scans come: new ones are drawn over the others, and all again only when
/// one of these has moved, as when a loop closes. It is the map that [ScanMapper#draw] draws, to the bit.
///
/// Scans that hardly moved are drawn again, too: where they were left up to a third of a cell from where they belong,
/// walls had holes through which there seemed to be more to map, and one robot alone took a seventh longer.
///
/// Not safe for several threads at once.
public final class IncrementalMap {
    private final ScanMapper.Settings settings;
    private final List<PosedScan> drawn = new ArrayList<>();
    private ScanMapper mapper;

    public IncrementalMap(ScanMapper.Settings settings) {
        this.settings = settings;
        this.mapper = new ScanMapper(settings);
    }

    /// The map of all scans.
    ///
    /// @param scans in the order in which they are drawn; new ones last, or all is drawn again
    /// @throws IllegalArgumentException as [ScanMapper#draw] does
    public OccupancyGrid of(List<PosedScan> scans) {
        if (scans.size() < drawn.size() || !drawn.equals(scans.subList(0, drawn.size()))) {
            drawn.clear();
            mapper = new ScanMapper(settings);
        }
        List<PosedScan> more = scans.subList(drawn.size(), scans.size());
        mapper.add(more);
        drawn.addAll(more);
        return mapper.grid();
    }
}
