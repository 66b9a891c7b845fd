package rsal.data;

/// Samples of a belief about a pose: `poses` holds x, y [m], heading [rad] of one particle after the other;
/// `weights` sum to 1. Both arrays are handed over, not shared.
public record ParticleCloud(float[] poses, float[] weights) {
    public int count() {
        return weights.length;
    }
}
