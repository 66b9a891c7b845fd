package rsal.navigation.amcl;

import java.util.List;
import java.util.random.RandomGenerator;
import rsal.data.Angles;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;

/// Adaptive Monte Carlo localization: Thrun, Burgard, Fox, Probabilistic Robotics, table 8.3, with as many
/// particles as the belief needs ([Kld]).
///
/// Differs from the book in these points:
/// * A scan counts as [Settings#independentBeams] beams, however many it has, since beams side by side see the
///   same wall; else the belief would be far too sure.
/// * It resamples only when the weights have become uneven, with low variance (table 4.4).
/// * Whether it is lost is not told by the mean weight (w_fast, w_slow) but by beams that went through walls,
///   soon, or that ended short of them, late: other robots that stand around must not scatter the particles. New
///   particles come from where on the map the scan fits ([GlobalSearch]), not from anywhere, and only if it fits
///   better there.
///
/// Not safe for several threads at once; the map is shared.
public final class Amcl {
    private static final int FEWEST_BEAMS = 5; // for a global search
    private static final int CANDIDATES = 60;
    private static final int UPDATES_BETWEEN_SEARCHES = 10;
    private static final double ANYWHERE_SHARE = 0.1;
    private static final double INJECTED_SHARE = 0.2;
    private static final double SLOW = 0.02; // share of the newest scan, as α_slow in the book
    private static final double FAST = 0.2; // as α_fast in the book
    private static final double LEAST_FIT = 0.6; // share of hits among the beams that tell
    private static final double MOST_SHORT = 0.7; // of all beams
    private static final double BETTER = 0.1; // mean logarithm of a beam's likelihood

    /// @param minParticles tracked with at least
    /// @param maxParticles never more than
    /// @param independentBeams how many beams a scan counts for
    /// @param updateDistance way after which a scan is looked at [m]
    /// @param updateTurn turn after which a scan is looked at [rad]
    public record Settings(
            int minParticles,
            int maxParticles,
            double independentBeams,
            double updateDistance,
            double updateTurn,
            OdometryModel odometry,
            Kld kld) {}

    /// What came of an update.
    public record Belief(PoseEstimate estimate, ParticleCloud particles) {}

    private final Settings settings;
    private final LocalizationMap map;
    private final RandomGenerator random;
    private final GlobalSearch search;
    private final PoseBins bins;
    private final Clusters clusters;
    private final double[] logs;
    private Particles particles;
    private Particles spare;
    private Pose2d odomFromBase = Pose2d.ORIGIN;
    private boolean fresh = true;
    private boolean anywhere = true;
    private boolean settled;
    private int updatesSinceSearch;
    private double fit;
    private double shortShare;

    /// Knows nothing yet: starts anywhere on the map.
    public Amcl(LocalizationMap map, Settings settings, RandomGenerator random) {
        this.settings = settings;
        this.map = map;
        this.random = random;
        this.search = new GlobalSearch(map);
        this.particles = new Particles(settings.maxParticles());
        this.spare = new Particles(settings.maxParticles());
        this.bins = new PoseBins(0.5, 36, settings.maxParticles());
        this.clusters = new Clusters(settings.maxParticles());
        this.logs = new double[settings.maxParticles()];
    }

    /// Starts again from a belief, drawn as KLD-sampling does: as many particles as the bins they fall into ask
    /// for.
    public void start(PoseEstimate belief) {
        restart(false);
        List<Hypothesis> hypotheses = belief.hypotheses();
        bins.clear();
        particles.count = 0;
        int wanted = settings.minParticles();
        while (particles.count < wanted) {
            add(hypotheses.isEmpty() ? new Hypothesis(1, belief.mapFromBase(), belief.covariance()) : draw(hypotheses));
            int last = particles.count - 1;
            bins.add(particles.x[last], particles.y[last], particles.theta[last]);
            wanted = bounded(settings.kld().particles(bins.count()));
        }
        particles.weighEqually();
    }

    /// Starts again knowing nothing.
    public void startAnywhere() {
        restart(true);
    }

    /// Whether the robot has moved enough, or started again, to look at a scan.
    public boolean due(Pose2d odomFromBase) {
        return fresh || !odomFromBase.isNear(this.odomFromBase, settings.updateDistance(), settings.updateTurn());
    }

    /// Moves the belief to where odometry says the robot went since the last update, and corrects it by what the
    /// beams hit there.
    public Belief update(Pose2d odomFromBase, Beams beams) {
        if (anywhere) {
            scatter(beams);
        } else if (!fresh) {
            settings.odometry().move(this.odomFromBase, odomFromBase, particles, random);
        }
        this.odomFromBase = odomFromBase;
        fresh = false;
        if (beams.count() > 0) {
            weigh(beams);
        }
        PoseEstimate estimate = clusters.estimate(particles);
        settled = estimate.hypotheses().getFirst().weight() > 0.9;
        boolean lost = beams.count() > 0 && !fits(beams, estimate.mapFromBase());
        if (particles.effectiveCount() < particles.count / 2.0 || wrongSize()) {
            resample();
        }
        updatesSinceSearch++;
        if ((lost || !settled) && updatesSinceSearch >= UPDATES_BETWEEN_SEARCHES && beams.count() >= FEWEST_BEAMS) {
            inject(beams, estimate.mapFromBase());
        }
        return new Belief(estimate, particles.cloud());
    }

    private void restart(boolean anywhere) {
        this.anywhere = anywhere;
        fresh = true;
        settled = !anywhere;
        updatesSinceSearch = 0;
        fit = 1;
        shortShare = 0;
    }

    private Hypothesis draw(List<Hypothesis> hypotheses) {
        double left = random.nextDouble()
                * hypotheses.stream().mapToDouble(Hypothesis::weight).sum();
        for (Hypothesis hypothesis : hypotheses) {
            left -= hypothesis.weight();
            if (left < 0) {
                return hypothesis;
            }
        }
        return hypotheses.getFirst();
    }

    /// A particle from a hypothesis's normal distribution, by the Cholesky factor of its covariance.
    private void add(Hypothesis hypothesis) {
        var c = hypothesis.covariance();
        double l00 = Math.sqrt(Math.max(0, c.xx()));
        double l10 = l00 > 0 ? c.xy() / l00 : 0;
        double l20 = l00 > 0 ? c.xTheta() / l00 : 0;
        double l11 = Math.sqrt(Math.max(0, c.yy() - l10 * l10));
        double l21 = l11 > 0 ? (c.yTheta() - l20 * l10) / l11 : 0;
        double l22 = Math.sqrt(Math.max(0, c.thetaTheta() - l20 * l20 - l21 * l21));
        double a = random.nextGaussian();
        double b = random.nextGaussian();
        double d = random.nextGaussian();
        Pose2d mean = hypothesis.mapFromBase();
        particles.add(
                mean.x() + l00 * a,
                mean.y() + l10 * a + l11 * b,
                Angles.wrap(mean.theta() + l20 * a + l21 * b + l22 * d));
    }

    private int bounded(int wanted) {
        return Math.clamp(wanted, settings.minParticles(), settings.maxParticles());
    }

    /// Particles where the scan could have been taken, and some anywhere.
    private void scatter(Beams beams) {
        anywhere = false;
        particles.count = 0;
        int scattered = particles.capacity();
        if (beams.count() >= FEWEST_BEAMS) {
            var candidates = search.candidates(beams, CANDIDATES);
            scattered = candidates.isEmpty() ? scattered : (int) (ANYWHERE_SHARE * scattered);
            for (int i = 0; particles.count < particles.capacity() - scattered; i++) {
                addNear(candidates.get(i % candidates.size()).mapFromBase());
            }
        }
        for (int i = 0; i < scattered; i++) {
            addAnywhere();
        }
        particles.weighEqually();
    }

    private void addNear(Pose2d pose) {
        particles.add(
                pose.x() + 0.1 * random.nextGaussian(),
                pose.y() + 0.1 * random.nextGaussian(),
                Angles.wrap(pose.theta() + 0.05 * random.nextGaussian()));
    }

    private void addAnywhere() {
        double x;
        double y;
        int tries = 0;
        do {
            x = map.grid.originX() + random.nextDouble() * map.grid.width() * map.grid.resolution();
            y = map.grid.originY() + random.nextDouble() * map.grid.height() * map.grid.resolution();
        } while (!map.grid.isFree(x, y) && ++tries < 1000); // a map without free cells must not hang us
        particles.add(x, y, Angles.wrap(random.nextDouble() * 2 * Math.PI));
    }

    private void weigh(Beams beams) {
        double beamWeight = Math.min(1, settings.independentBeams() / beams.count());
        double best = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < particles.count; i++) {
            logs[i] = beamWeight * map.walls.log(beams, particles.x[i], particles.y[i], particles.theta[i]);
            best = Math.max(best, logs[i]);
        }
        double sum = 0;
        for (int i = 0; i < particles.count; i++) {
            particles.weight[i] *= Math.exp(logs[i] - best);
            sum += particles.weight[i];
        }
        if (!(sum > 0)) { // all the weight was where the scan can't be
            particles.weighEqually();
            return;
        }
        for (int i = 0; i < particles.count; i++) {
            particles.weight[i] /= sum;
        }
    }

    /// Follows how well scans fit the estimate. Beams that end short of the map's walls do not count, since
    /// something may stand there, unless most do so for long; beams that went through walls can't be explained at
    /// all.
    private boolean fits(Beams beams, Pose2d mapFromBase) {
        int hits = 0;
        int through = 0;
        for (int i = 0; i < beams.count(); i++) {
            switch (search.verdict(beams, i, mapFromBase)) {
                case HIT -> hits++;
                case THROUGH -> through++;
                case SHORT -> {}
            }
        }
        int told = hits + through;
        shortShare += SLOW * ((double) (beams.count() - told) / beams.count() - shortShare);
        if (told >= FEWEST_BEAMS) {
            fit += FAST * ((double) hits / told - fit);
        }
        return fit >= LEAST_FIT && shortShare <= MOST_SHORT;
    }

    private boolean wrongSize() {
        bins.clear();
        for (int i = 0; i < particles.count; i++) {
            bins.add(particles.x[i], particles.y[i], particles.theta[i]);
        }
        int wanted = bounded(settings.kld().particles(bins.count()));
        return particles.count > 2 * wanted || 2 * particles.count < wanted;
    }

    /// Draws as many particles as the bins of those that survive ask for. A first draw only counts these bins.
    private void resample() {
        bins.clear();
        draw(particles.count, (x, y, theta) -> bins.add(x, y, theta));
        spare.count = 0;
        draw(bounded(settings.kld().particles(bins.count())), spare::add);
        spare.weighEqually();
        swap();
    }

    /// Low variance sampling: Thrun, Burgard, Fox, Probabilistic Robotics, table 4.4.
    private void draw(int count, Draw into) {
        double step = 1.0 / count;
        double at = random.nextDouble() * step;
        double reached = particles.weight[0];
        int i = 0;
        for (int drawn = 0; drawn < count; drawn++) {
            while (reached < at && i < particles.count - 1) {
                reached += particles.weight[++i];
            }
            into.take(particles.x[i], particles.y[i], particles.theta[i]);
            at += step;
        }
    }

    @FunctionalInterface
    private interface Draw {
        void take(double x, double y, double theta);
    }

    /// Puts some particles where the scan fits better than at the estimate.
    private void inject(Beams beams, Pose2d estimate) {
        updatesSinceSearch = 0;
        double toBeat = search.score(beams, estimate) + (settled ? BETTER : 0);
        var better = search.candidates(beams, CANDIDATES / 4).stream()
                .filter(c -> c.score() > toBeat && !c.mapFromBase().isNear(estimate, 0.5, 0.3))
                .toList();
        if (better.isEmpty()) {
            return;
        }
        int injected = Math.max(better.size(), (int) (INJECTED_SHARE * particles.count));
        spare.count = 0;
        draw(Math.min(particles.count, particles.capacity() - injected), spare::add);
        swap();
        for (int i = 0; i < injected; i++) {
            addNear(better.get(i % better.size()).mapFromBase());
        }
        particles.weighEqually();
    }

    private void swap() {
        Particles sampled = spare;
        spare = particles;
        particles = sampled;
    }
}
