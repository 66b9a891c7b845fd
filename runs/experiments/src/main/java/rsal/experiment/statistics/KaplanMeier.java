package rsal.experiment.statistics;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.apache.commons.statistics.distribution.NormalDistribution;

/// How likely it is that something has not happened yet, by time, also where some runs ended before it happened: E.
/// Kaplan, P. Meier, Nonparametric estimation from incomplete observations, JASA 53(282), 1958. Runs that ended early
/// must not differ from the others in when it would have happened.
///
/// Immutable.
public final class KaplanMeier {
    private static final double NORMAL =
            NormalDistribution.of(0, 1).inverseSurvivalProbability((1 - ConfidenceInterval.CONFIDENCE) / 2);

    private final List<Observation> observations; // by time; at the same time, what happened comes first
    private final List<Step> steps;

    /// A time at which it happened.
    ///
    /// @param atRisk runs in which it could still happen just before
    /// @param happened in how many of them it happened then
    /// @param share probability that it has not happened by then, including this time
    /// @param interval of the share, pointwise, on the scale of log(−log), with Greenwood's variance: J.
    /// Kalbfleisch,
    /// R. Prentice, The Statistical Analysis of Failure Time Data, 2nd edition, 2002, section 1.4
    public record Step(double time, int atRisk, int happened, double share, ConfidenceInterval interval) {}

    private KaplanMeier(List<Observation> observations) {
        this.observations = observations;
        var found = new ArrayList<Step>();
        double share = 1;
        double greenwood = 0;
        for (int i = 0; i < observations.size(); ) {
            double time = observations.get(i).time();
            int atRisk = observations.size() - i;
            int happened = 0;
            for (; i < observations.size() && observations.get(i).time() == time; i++) {
                happened += observations.get(i).happened() ? 1 : 0;
            }
            if (happened > 0) {
                share *= 1 - (double) happened / atRisk;
                greenwood += (double) happened / atRisk / (atRisk - happened); // infinite where none is left
                found.add(new Step(time, atRisk, happened, share, interval(share, greenwood)));
            }
        }
        this.steps = List.copyOf(found);
    }

    /// @param observations of runs that are independent of each other, at least one
    public static KaplanMeier of(List<Observation> observations) {
        if (observations.isEmpty()) {
            throw new IllegalArgumentException("There is no curve of nothing.");
        }
        return new KaplanMeier(observations.stream()
                .sorted(Comparator.comparingDouble(Observation::time)
                        .thenComparing(Observation::happened, Comparator.reverseOrder()))
                .toList());
    }

    private static ConfidenceInterval interval(double share, double greenwood) {
        if (share == 0) {
            return new ConfidenceInterval(0, 0);
        }
        double margin = NORMAL * Math.sqrt(greenwood) / Math.log(share);
        return new ConfidenceInterval(Math.pow(share, Math.exp(-margin)), Math.pow(share, Math.exp(margin)));
    }

    /// Ascending by time; none when it never happened.
    public List<Step> steps() {
        return steps;
    }

    public int count() {
        return observations.size();
    }

    /// In how many runs it happened.
    public int happened() {
        return steps.stream().mapToInt(Step::happened).sum();
    }

    /// When runs ended before it happened; those in which it can never happen are not in it.
    public List<Double> censored() {
        return observations.stream()
                .filter(each -> !each.happened() && Double.isFinite(each.time()))
                .map(Observation::time)
                .toList();
    }

    /// Probability that it has not happened by a time, including this time.
    public double share(double time) {
        return step(time).map(Step::share).orElse(1.0);
    }

    /// The last that is not later.
    private Optional<Step> step(double time) {
        int number = (int) steps.stream().filter(step -> step.time() <= time).count();
        return number == 0 ? Optional.empty() : Optional.of(steps.get(number - 1));
    }

    /// When it has happened in half of all runs; empty where it did not in so many.
    public OptionalDouble median() {
        return steps.stream()
                .filter(step -> step.share() <= 0.5)
                .mapToDouble(Step::time)
                .findFirst();
    }

    /// Until when the curve is known: +∞ when it got down to 0, or when it is known that it can't any more.
    public double known() {
        Observation last = observations.getLast();
        return last.happened() ? Double.POSITIVE_INFINITY : last.time();
    }

    /// The mean of the time until it happens or the horizon comes, whichever is first: the area below the curve. P.
    /// Royston, M. Parmar, Restricted mean survival time, BMC Medical Research Methodology 13:152, 2013, equation
    ///     1.
    ///
    /// @param horizon at most [#known], finite
    public double restrictedMean(double horizon) {
        double mean = 0;
        double from = 0;
        double share = 1;
        for (Step step : steps) {
            if (step.time() >= horizon) {
                break;
            }
            mean += share * (step.time() - from);
            from = step.time();
            share = step.share();
        }
        return mean + share * (horizon - from);
    }

    /// What each run adds to the restricted mean, so that runs with the same seed can be compared one by one:
    /// n θ − (n − 1) θ₋ᵢ, where θ₋ᵢ is the restricted mean without the run. P. Andersen, M. Hansen, J. Klein,
    /// Regression analysis of restricted mean survival time based on pseudo-observations, Lifetime Data
    /// Analysis 10(4), 2004, equation 2. Where no run ended before the horizon they are the times, cut there.
    ///
    /// @param runs those of the curve
    /// @param horizon at most [#known], finite
    /// @return one for each run, in their order
    public double[] pseudoTimes(List<Observation> runs, double horizon) {
        int count = count();
        double all = restrictedMean(horizon);
        var without = new LeftOut(steps, horizon);
        return runs.stream()
                .mapToDouble(run -> count == 1 ? all : count * all - (count - 1) * without.restrictedMean(run))
                .toArray();
    }

    /// The restricted mean without one of the runs, for all of them in linear time: a run is at risk until it ends,
    /// and after that the curve falls as it does with the run.
    private static final class LeftOut {
        private final double horizon;
        private final List<Step> steps; // before the horizon
        private final double[] shares; // after so many steps, each with a run less at risk
        private final double[] heads; // area up to the last of so many steps, the same
        private final double[] tails; // area from there to the horizon, with all runs, if the share were 1 there

        LeftOut(List<Step> all, double horizon) {
            this.horizon = horizon;
            this.steps = all.stream().filter(step -> step.time() < horizon).toList();
            int count = steps.size();
            shares = new double[count + 1];
            heads = new double[count + 1];
            tails = new double[count + 1];
            shares[0] = 1;
            for (int i = 0; i < count; i++) {
                Step step = steps.get(i);
                heads[i + 1] = heads[i] + shares[i] * (step.time() - time(i));
                shares[i + 1] =
                        step.atRisk() == 1 ? 0 : shares[i] * (1 - (double) step.happened() / (step.atRisk() - 1));
            }
            tails[count] = horizon - time(count);
            for (int i = count - 1; i >= 0; i--) {
                Step step = steps.get(i);
                tails[i] = step.time() - time(i) + (1 - (double) step.happened() / step.atRisk()) * tails[i + 1];
            }
        }

        private double time(int after) {
            return after == 0 ? 0 : steps.get(after - 1).time();
        }

        double restrictedMean(Observation run) {
            int passed = passed(run.time());
            if (!run.happened() || run.time() >= horizon) {
                return heads[passed] + shares[passed] * tails[passed];
            }
            Step own = steps.get(passed - 1);
            double falls = own.atRisk() == 1 ? 0 : (own.happened() - 1.0) / (own.atRisk() - 1);
            return heads[passed] + shares[passed - 1] * (1 - falls) * tails[passed];
        }

        /// Steps that are not later than a time, by halving.
        private int passed(double time) {
            int low = 0;
            int high = steps.size();
            while (low < high) {
                int middle = (low + high) / 2;
                if (steps.get(middle).time() <= time) {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            return low;
        }
    }
}
