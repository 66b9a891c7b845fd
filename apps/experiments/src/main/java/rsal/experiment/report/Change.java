package rsal.experiment.report;

import rsal.experiment.statistics.Effect;

/// What it does to a measure to change a factor from one level to another.
record Change(String factor, String from, String to, Effect effect) {
    /// `hunters 2 → 3`
    @Override
    public String toString() {
        return "%s %s → %s".formatted(factor, from, to);
    }
}
