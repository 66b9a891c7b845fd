package rsal.navigation.rooms;

/// Compares rooms that were found with rooms that are known.
final class Segmentations {
    private Segmentations() {}

    /// Matthews' correlation of each known room with the found one that shares most of its cells, weighted by
    /// cells: 1 when all are the same, 0 for chance. M. Mielle, M. Magnusson, A. Lilienthal, A method to
    /// segment maps from different modalities using free space layout: MAORIS (ICRA 2018), use this measure,
    /// since precision and recall alone reward too many rooms, or too few.
    ///
    /// @param known by cell, negative for those that do not count
    /// @param found by cell, negative for those in none
    static double correlation(int[] known, int[] found) {
        int rooms = 0;
        int regions = 0;
        long counted = 0;
        for (int cell = 0; cell < known.length; cell++) {
            rooms = Math.max(rooms, known[cell] + 1);
            regions = Math.max(regions, found[cell] + 1);
            counted += known[cell] >= 0 ? 1 : 0;
        }
        var both = new long[rooms][regions];
        var inRoom = new long[rooms];
        var inRegion = new long[regions];
        for (int cell = 0; cell < known.length; cell++) {
            if (known[cell] >= 0) {
                inRoom[known[cell]]++;
                if (found[cell] >= 0) {
                    inRegion[found[cell]]++;
                    both[known[cell]][found[cell]]++;
                }
            }
        }
        double sum = 0;
        for (int room = 0; room < rooms; room++) {
            int best = 0;
            for (int region = 0; region < regions; region++) {
                best = both[room][region] > both[room][best] ? region : best;
            }
            double hits = regions == 0 ? 0 : both[room][best];
            double extra = regions == 0 ? 0 : inRegion[best] - hits;
            double missed = inRoom[room] - hits;
            double others = counted - hits - extra - missed;
            double norm = Math.sqrt((hits + extra) * (hits + missed) * (others + extra) * (others + missed));
            boolean isAll = extra == 0 && missed == 0;
            sum += inRoom[room] * (isAll ? 1 : norm == 0 ? 0 : (hits * others - extra * missed) / norm);
        }
        return sum / counted;
    }
}
