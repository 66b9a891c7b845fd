package rsal.navigation.device;

import java.util.ArrayList;
import java.util.List;
import rsal.navigation.grid.ScanMapper.PosedScan;

/// Scans of several robots in the order in which they came, so that what was seen last is drawn last. Those that
/// come at once are in the order of their robots. A robot that begins another map takes back what it had told.
final class Sequence {
    private final List<Entry> entries = new ArrayList<>();
    private final List<Integer> counts = new ArrayList<>(); // by robot

    private record Entry(int robot, int scan) {}

    /// @param scans by robot, in the order in which they joined: those told before, where they lie now, and new
    /// ones
    List<PosedScan> of(List<List<PosedScan>> scans) {
        for (int robot = 0; robot < scans.size(); robot++) {
            int count = scans.get(robot).size();
            if (robot == counts.size()) {
                counts.add(0);
            }
            if (count < counts.get(robot)) {
                int begun = robot;
                entries.removeIf(entry -> entry.robot == begun);
                counts.set(robot, 0);
            }
            for (int scan = counts.get(robot); scan < count; scan++) {
                entries.add(new Entry(robot, scan));
            }
            counts.set(robot, count);
        }
        return entries.stream()
                .map(entry -> scans.get(entry.robot).get(entry.scan))
                .toList();
    }
}
