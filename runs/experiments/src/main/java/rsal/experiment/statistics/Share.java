package rsal.experiment.statistics;

/// Of how many something was so.
///
/// @param of all, at least 1
public record Share(int count, int of) {
    private static final double NORMAL = 1.959963984540054; // 97.5 % quantile of the normal distribution

    public Share {
        if (count < 0 || of < 1 || count > of) {
            throw new IllegalArgumentException("(%d of %d) is not a share.".formatted(count, of));
        }
    }

    public double value() {
        return (double) count / of;
    }

    /// Of the probability that it is from, by the score: E. Wilson, Probable inference, the law of
    /// succession, and statistical inference, JASA 22, 1927; as in L. Brown, T. Cai, A. DasGupta, Interval
    /// estimation for a binomial proportion, Statistical Science 16(2), 2001, equation 4. Unlike the usual
    /// one it says something where nothing or all was so, and is right for few, too.
    public ConfidenceInterval interval() {
        double squared = NORMAL * NORMAL;
        double middle = (count + squared / 2) / (of + squared);
        double margin =
                NORMAL * Math.sqrt(of) / (of + squared) * Math.sqrt(value() * (1 - value()) + squared / (4 * of));
        return new ConfidenceInterval(count == 0 ? 0 : middle - margin, count == of ? 1 : middle + margin);
    }
}
