package rsal.navigation.spread;

/// The lengths of the paths between all pairs of a few thousand [Patches], and how much each patch counts.
/// Never changes once it is computed, so that several [Medoids] may use it.
///
/// @param weights of each patch [cells]
/// @param squares of the length of the path, by pair: that from patch i to patch j at i * size + j
/// @param beyond more than any of the squares
record PatchDistances(double[] weights, float[] squares, float beyond) {
    /// Memory and time grow with its square: 16 MB.
    static final int MOST = 2000;

    /// @param patches at most [#MOST]
    static PatchDistances between(Patches patches) {
        int size = patches.count();
        var weights = new double[size];
        var squares = new float[size * size];
        var flood = new Flood(patches);
        float most = 0;
        for (int from = 0; from < size; from++) {
            weights[from] = patches.weight(from);
            flood.clear();
            flood.source(from, 0);
            flood.flood();
            for (int to = 0; to < size; to++) {
                float distance = flood.distance(to);
                squares[from * size + to] = distance * distance;
                most = Math.max(most, distance * distance);
            }
        }
        return new PatchDistances(weights, squares, 2 * most + 1);
    }

    int size() {
        return weights.length;
    }
}
