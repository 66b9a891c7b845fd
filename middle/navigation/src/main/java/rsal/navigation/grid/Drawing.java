package rsal.navigation.grid;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Angles;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.navigation.grid.ScanMapper.PosedScan;

/// A map that is drawn again and again while scans come, and while those that are there move a little: new scans
/// are drawn over the others, and all anew only when one of these moved so far that it shows ([#STILL]), as when a
/// loop closes. Scans that never moved give the map that [ScanMapper#draw] draws of them, to the bit; others lie
/// where they were when they were drawn.
///
/// Not safe for several threads at once.
public final class Drawing {
    /// So far the farthest that a scan draws may move, in cells, before it is drawn anew.
    public static final double STILL = 1.0 / 3;

    private final ScanMapper.Settings settings;
    private final double reach;
    private final List<PosedScan> drawn = new ArrayList<>();
    private ScanMapper mapper;

    public Drawing(ScanMapper.Settings settings) {
        this.settings = settings;
        this.reach = Math.max(settings.maxRange(), settings.freeUpTo());
        this.mapper = new ScanMapper(settings);
    }

    /// The map of all scans.
    ///
    /// @param scans in the order in which they are drawn; new ones last, or all is drawn anew
    /// @throws IllegalArgumentException as [ScanMapper#draw] does
    public OccupancyGrid of(List<PosedScan> scans) {
        if (!goesOn(scans)) {
            drawn.clear();
            mapper = new ScanMapper(settings);
        }
        List<PosedScan> more = scans.subList(drawn.size(), scans.size());
        mapper.add(more);
        drawn.addAll(more);
        return mapper.grid();
    }

    /// Whether scans begin with those that are drawn, about where they are drawn.
    private boolean goesOn(List<PosedScan> scans) {
        if (scans.size() < drawn.size()) {
            return false;
        }
        for (int i = 0; i < drawn.size(); i++) {
            if (!isStill(drawn.get(i), scans.get(i))) {
                return false;
            }
        }
        return true;
    }

    private boolean isStill(PosedScan before, PosedScan now) {
        Pose2d was = before.mapFromBase();
        Pose2d is = now.mapFromBase();
        double turned = Math.abs(Angles.difference(was.theta(), is.theta()));
        return before.scan().equals(now.scan()) && was.distanceTo(is) + reach * turned <= STILL * settings.resolution();
    }
}
