package rsal.navigation.amcl;

/// How many particles a belief needs: D. Fox, Adapting the Sample Size in Particle Filters Through KLD-Sampling,
/// International Journal of Robotics Research 22 (2003), equation 13, with the Wilson-Hilferty approximation of
/// the χ² distribution.
///
/// @param error how far the sampled distribution may be from the true one (ε), as Kullback-Leibler distance
/// @param quantile of the standard normal distribution with which the error is kept (z₁₋δ; 2.33 for 99 %)
public record Kld(double error, double quantile) {

    /// @param bins of the pose space in which the belief has particles (k)
    public int particles(int bins) {
        if (bins <= 1) {
            return 1;
        }
        double k = bins - 1;
        double a = 2 / (9 * k);
        double b = 1 - a + Math.sqrt(a) * quantile;
        return (int) Math.ceil(k / (2 * error) * b * b * b);
    }
}
