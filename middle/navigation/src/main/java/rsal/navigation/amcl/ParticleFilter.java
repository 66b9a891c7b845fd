package rsal.navigation.amcl;

import java.util.List;
import java.util.random.RandomGenerator;
import rsal.data.Angles;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;

/// The particles of [Amcl]: moved by odometry, weighed by scans, and drawn again with as many as the belief
/// needs ([Kld]): Thrun, Burgard, Fox, Probabilistic Robotics, table 8.3. They are drawn again only when their
/// weights have become uneven, with low variance (table 4.4). Not safe for several threads at once; the map is
/// shared.
final class ParticleFilter {
    private static final double ANYWHERE_SHARE = 0.1;
    private static final double INJECTED_SHARE = 0.2;

    private final Amcl.Settings settings;
    private final LocalizationMap map;
    private final RandomGenerator random;
    private final PoseBins bins = new PoseBins(0.5, 36);
    private final Clusters clusters = new Clusters();
    private final PoseBlock block = new PoseBlock();
    private double[] logs = {};
    private int[] drawn = {};
    private Particles particles;
    private Particles spare;

    ParticleFilter(LocalizationMap map, Amcl.Settings settings, RandomGenerator random) {
        this.settings = settings;
        this.map = map;
        this.random = random;
        this.particles = new Particles(settings.maxParticles());
        this.spare = new Particles(settings.maxParticles());
    }

    /// Starts again from a belief, drawn as KLD-sampling does: as many particles as the bins they fall into ask
    /// for.
    void start(PoseEstimate belief) {
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

    /// Moves the particles as odometry says that the robot moved.
    ///
    /// @param more variance along the way [m²], besides what the model of odometry says
    void move(Pose2d odomFromBefore, Pose2d odomFromBase, double more) {
        settings.odometry().move(odomFromBefore, odomFromBase, more, particles, random);
    }

    /// Where the robot is, by clusters of particles.
    PoseEstimate estimate() {
        return clusters.estimate(particles);
    }

    /// Draws the particles again where they are uneven, too many or too few.
    void resampleIfDue() {
        if (particles.effectiveCount() < particles.count / 2.0 || isWrongSize()) {
            resample();
        }
    }

    ParticleCloud cloud() {
        return particles.cloud();
    }

    int count() {
        return particles.count;
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

    /// Starts again with particles near some poses, and some anywhere.
    ///
    /// @param mapFromCandidates none when nobody knows where it could be
    void scatter(List<Pose2d> mapFromCandidates) {
        particles.count = 0;
        int anywhere =
                mapFromCandidates.isEmpty() ? particles.capacity() : (int) (ANYWHERE_SHARE * particles.capacity());
        for (int i = 0; particles.count < particles.capacity() - anywhere; i++) {
            addNear(mapFromCandidates.get(i % mapFromCandidates.size()));
        }
        for (int i = 0; i < anywhere; i++) {
            addAnywhere();
        }
        particles.weighEqually();
    }

    private void addNear(Pose2d pose) {
        particles.add(
                pose.x() + AlternativeHypotheses.DEVIATION * random.nextGaussian(),
                pose.y() + AlternativeHypotheses.DEVIATION * random.nextGaussian(),
                Angles.wrap(pose.theta() + AlternativeHypotheses.TURN_DEVIATION * random.nextGaussian()));
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

    /// Weighs particles by how likely a scan is at each: Probabilistic Robotics, table 8.3, line 5.
    ///
    /// @param trust how much the scan counts, 1 at most
    void weigh(Beams beams, double trust) {
        double beamWeight = trust * Math.min(1, settings.independentBeams() / beams.count());
        double best = Double.NEGATIVE_INFINITY;
        if (particles.count > logs.length) {
            logs = new double[particles.x.length];
        }
        switch (settings.model()) {
            case FIELD -> map.walls.logs(beams, particles, block, logs);
            case BEAM -> map.reaches.logs(beams, particles, block, logs);
        }
        for (int i = 0; i < particles.count; i++) {
            logs[i] *= beamWeight;
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

    private boolean isWrongSize() {
        bins.clear();
        for (int i = 0; i < particles.count; i++) {
            bins.add(particles.x[i], particles.y[i], particles.theta[i]);
        }
        int wanted = bounded(settings.kld().particles(bins.count()));
        return particles.count > 2 * wanted || 2 * particles.count < wanted;
    }

    /// Draws as many particles as the bins of those that survive ask for. A first draw only counts these bins.
    private void resample() {
        draw(particles.count);
        bins.clear();
        for (int i = 0; i < particles.count; i++) {
            if (i == 0 || drawn[i] != drawn[i - 1]) {
                bins.add(particles.x[drawn[i]], particles.y[drawn[i]], particles.theta[drawn[i]]);
            }
        }
        survive(bounded(settings.kld().particles(bins.count())));
        particles.weighEqually();
    }

    /// Replaces the particles by so many that are drawn from them.
    private void survive(int count) {
        draw(count);
        spare.take(particles, drawn, count);
        Particles before = particles;
        particles = spare;
        spare = before;
    }

    /// Which particles are drawn, in their order, by low variance sampling: Thrun, Burgard, Fox, Probabilistic
    /// Robotics, table 4.4.
    private void draw(int count) {
        if (count > drawn.length) {
            drawn = new int[Math.max(count, particles.x.length)];
        }
        double step = 1.0 / count;
        double at = random.nextDouble() * step;
        double reached = particles.weight[0];
        int i = 0;
        for (int n = 0; n < count; n++) {
            while (reached < at && i < particles.count - 1) {
                reached += particles.weight[++i];
            }
            drawn[n] = i;
            at += step;
        }
    }

    /// Puts some particles near a pose, in place of others.
    void inject(Pose2d mapFromPose) {
        int injected = makeRoom(1);
        for (int i = 0; i < injected; i++) {
            addNear(mapFromPose);
        }
        particles.weighEqually();
    }

    /// @return how many particles can be added now, at least as many as said
    private int makeRoom(int least) {
        int injected = Math.max(least, (int) (INJECTED_SHARE * particles.count));
        survive(Math.min(particles.count, particles.capacity() - injected));
        return injected;
    }
}
