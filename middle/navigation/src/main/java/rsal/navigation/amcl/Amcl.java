package rsal.navigation.amcl;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;
import rsal.navigation.amcl.GlobalSearch.Fates;

/// Adaptive Monte Carlo localization: Thrun, Burgard, Fox, Probabilistic Robotics, table 8.3, with as many
/// particles as the belief needs ([Kld]).
///
/// Differs from the book in these points:
/// * A scan counts as [Settings#independentBeams] beams, however many it has, since beams side by side see the
///   same wall; else the belief would be far too sure.
/// * It resamples only when the weights have become uneven, with low variance (table 4.4).
/// * Whether it is lost is not told by the mean weight (w_fast, w_slow) but by what became of the beams at the
///   one pose that is believed ([LocalizationMonitor]). New particles come from where on the map the scan fits
///   ([GlobalSearch]), not from anywhere, and only if it fits better there ([AlternativeHypotheses]).
/// * A pose that was known once is *followed*: odometry is unbroken, so that the robot is nowhere else unless it was
///   carried. Places that fit better are followed beside it and replace it after long and unambiguous evidence
///   ([Challengers]). It is lost where the map explains too few beams, not where some go through walls
///   ([TrackingMonitor]): furniture and walls may have been moved. Where little is explained, a scan counts less.
/// * A scale by which odometry is wrong is estimated while a pose is followed; what is not known of it makes the pose
///   uncertain where scans do not tell how far the robot went, as along a corridor ([OdometryScale]).
///
/// What it tells:
/// * [Quality#LOCALIZED]: scans have spoken for the pose since it was first believed (20 to 1), no other place
///   was as good, nine tenths of the belief are here, within half a meter. Of a pose that is followed the map explains
///   six of ten beams, and no other place has been better for half a meter.
/// * [Quality#LOST]: scans have spoken against the pose (7 to 1) and not for it since, when it searches; or of
///   the newest scan's beams that reach walls more than seven of ten go through; or 30 updates have seen
///   nothing.
/// * [Quality#AMBIGUOUS]: all else.
///
/// Confidence is the share of the belief that is here times how likely scans make the pose, and 0.97 for each
/// update in a row that has seen nothing: 0.75 to 1 for localized, half of it for ambiguous, a tenth for lost.
///
/// Not safe for several threads at once; the map is shared.
public final class Amcl {
    private static final int FEWEST_BEAMS = 5; // for a global search
    private static final int CANDIDATES = 120;
    private static final int MOST_UPDATES_BETWEEN_SEARCHES = 10;
    private static final int SCANS_COMPARED = 5; // while the wheels stand, one of so many
    private static final double CONTRADICTED = 0.3; // share of beams through walls, by a scan alone
    private static final double ABOUT_THE_SAME = 0.25; // mean logarithm of a beam's likelihood
    private static final double DOUBT = -2; // logarithm of how likely a rival is that was not there before
    private static final int UPDATES_BEFORE_TRUST = 3;
    private static final int ENOUGH_OUTLASTED = 3; // sonars always find places that fit by chance
    private static final double LEAST_FIT_NOW = 0.3; // of one scan alone
    private static final double BROKEN = 3; // m, between two scans
    private static final double METERS_PER_RADIAN = 0.3; // that a turn counts for: it shows other walls
    private static final double LITTLE_EXPLAINED = 0.35; // share of the beams
    private static final double ENOUGH_MORE = 0.25; // the same
    private static final double LEAST_TRUST = 0.02;
    private static final double DRIFT_LOOKED_AT = 0.05; // m; to look at less would only cost time
    private static final double REFINED = 0.5; // trust with which a pose is refined
    private static final double NEAR = 0.5; // m; one hypothesis
    private static final double NEARLY = 0.35; // rad, the same
    private static final double SURE = 0.9; // of the belief
    private static final double PRECISE = 0.5; // m, standard deviation
    private static final int BLIND_AND_SURE = 5; // updates in a row without anything seen
    private static final int BLIND_AND_LOST = 30; // the same
    private static final double BLIND_TRUST = 0.97; // that is left by each of them
    private static final double MOST_AMBIGUOUS = 0.5; // of confidence
    private static final double MOST_LOST = 0.1; // the same

    /// @param minParticles tracked with at least
    /// @param maxParticles never more than
    /// @param independentBeams number of independent beams for which a scan counts
    /// @param updateDistance way after which a scan is looked at [m]
    /// @param updateTurn turn after which a scan is looked at [rad]
    /// @param model by which particles are weighed; searches and refinement always use the field
    public record Settings(
            int minParticles,
            int maxParticles,
            double independentBeams,
            double updateDistance,
            double updateTurn,
            OdometryModel odometry,
            Kld kld,
            SensorModel.Kind model) {

        /// By how near beams end to walls.
        public Settings(
                int minParticles,
                int maxParticles,
                double independentBeams,
                double updateDistance,
                double updateTurn,
                OdometryModel odometry,
                Kld kld) {
            this(
                    minParticles,
                    maxParticles,
                    independentBeams,
                    updateDistance,
                    updateTurn,
                    odometry,
                    kld,
                    SensorModel.Kind.FIELD);
        }

        /// The same with another model.
        public Settings with(SensorModel.Kind other) {
            return new Settings(
                    minParticles, maxParticles, independentBeams, updateDistance, updateTurn, odometry, kld, other);
        }

        /// Of a laser on a robot of which little is known: odometry may be several percent wrong.
        public static Settings of(int minParticles, int maxParticles) {
            return new Settings(
                    minParticles,
                    maxParticles,
                    15,
                    0.1,
                    Math.toRadians(6),
                    new OdometryModel(0.1, 0.06, 0.12),
                    new Kld(0.05, 2.33));
        }
    }

    private final Settings settings;
    private final ParticleFilter filter;
    private final GlobalSearch search;
    private final Refinement refinement;
    private final AlternativeHypotheses rivals;
    private final LocalizationMonitor evidence;
    private final Challengers challengers;
    private final TrackingMonitor monitor;
    private final OdometryScale scale = new OdometryScale();
    private boolean tracking; // it was known where it is, and odometry is unbroken since
    private Pose2d odomFromBase = Pose2d.ORIGIN;
    private boolean fresh = true;
    private boolean anywhere = true;
    private boolean lost = true;
    private int updatesSinceSearch;
    private int searchAfter;
    private double fitNow = 1;
    private final MisfitMonitor misfits = new MisfitMonitor();
    private int outlasted; // rivals that were found in so many searches have all been ruled out
    private boolean trusted; // no other place has been as good since it was last lost
    private int scansStanding; // since the last update
    private int blind; // updates in a row in which nothing was seen
    private @Nullable Hypothesis newest; // where it was at the last update

    /// Knows nothing yet: starts anywhere on the map. On one that is not [LocalizationMap#isSearchable] it stays lost
    /// until it is told where it is.
    public Amcl(LocalizationMap map, Settings settings, RandomGenerator random) {
        this.settings = settings;
        this.filter = new ParticleFilter(map, settings, random);
        this.search = new GlobalSearch(map);
        this.refinement = new Refinement(map.toFace, map.deviation, settings.independentBeams());
        this.rivals = new AlternativeHypotheses(search, refinement, settings.independentBeams());
        this.evidence = new LocalizationMonitor(settings.independentBeams());
        this.challengers = new Challengers(search, refinement, settings.independentBeams());
        this.monitor = new TrackingMonitor(settings.independentBeams());
    }

    /// Starts again from a belief, drawn as KLD-sampling does: as many particles as the bins they fall into ask
    /// for. One place is believed at once; where several are, it must turn out first that no other is as good.
    ///
    /// @throws IllegalArgumentException when any of the belief is not finite
    public void start(PoseEstimate belief) {
        if (!belief.isFinite()) {
            throw new IllegalArgumentException("'%s' can't be a pose estimate.".formatted(belief));
        }
        restart(false);
        trusted = isSingle(belief);
        if (trusted) {
            evidence.trust();
            track();
        }
        filter.start(belief);
    }

    private static boolean isSingle(PoseEstimate belief) {
        double sum = 0;
        double heaviest = 0;
        for (Hypothesis hypothesis : belief.hypotheses()) {
            sum += hypothesis.weight();
            heaviest = Math.max(heaviest, hypothesis.weight());
        }
        return belief.quality() == Quality.LOCALIZED && heaviest >= SURE * sum;
    }

    /// Starts again knowing nothing.
    public void startAnywhere() {
        restart(true);
    }

    /// Whether a scan is to be looked at: when the robot has moved enough, or started again. While its wheels stand, a
    /// laser's scan that can't be from where it is believed to be, as somebody may have carried it: every fifth is
    /// compared.
    ///
    /// @param beams are asked for only when they are compared
    public boolean due(Pose2d odomFromBase, Supplier<Beams> beams) {
        if (fresh || !odomFromBase.isNear(this.odomFromBase, settings.updateDistance(), settings.updateTurn())) {
            return true;
        }
        if (newest == null || ++scansStanding % SCANS_COMPARED != 0) {
            return false;
        }
        Beams seen = beams.get();
        Pose2d motion = this.odomFromBase.inverse().compose(odomFromBase);
        Fates fates = search.fates(seen, newest.mapFromBase().compose(motion));
        return seen.cone() == 0
                && fates.reported() >= FEWEST_BEAMS
                && fates.through() > CONTRADICTED * fates.reported();
    }

    /// Moves the belief to where odometry says the robot went since the last update, and corrects it by what the
    /// beams hit there.
    ///
    /// @throws IllegalArgumentException when the pose is not finite; the belief stays as it was
    public PoseEstimate update(Pose2d odomFromBase, Beams beams) {
        if (!odomFromBase.isFinite()) {
            throw new IllegalArgumentException("'%s' can't be odometry.".formatted(odomFromBase));
        }
        Pose2d reported = fresh ? Pose2d.ORIGIN : this.odomFromBase.inverse().compose(odomFromBase);
        Pose2d motion = scale.corrected(reported);
        if (anywhere) {
            scatter(beams);
        } else if (!fresh) {
            move(odomFromBase, reported, motion);
        }
        this.odomFromBase = odomFromBase;
        scansStanding = 0;
        fresh = false;
        if (beams.count() > 0) {
            filter.weigh(beams, trust());
        }
        PoseEstimate clustered = seen(filter.estimate(), motion, beams.count() > 0);
        Pose2d pose = trust() < REFINED
                ? clustered.mapFromBase()
                : refinement.refine(beams, clustered.mapFromBase(), clustered.covariance());
        if (newest != null && !newest.mapFromBase().compose(motion).isNear(pose, NEAR, NEARLY)) {
            evidence.restart(); // what spoke for the other place says nothing of this one
            monitor.restart();
            scale.restart();
            trusted = false;
        }
        if (beams.count() > 0) {
            judge(search.fates(beams, pose));
            lost = lost ? !present().speaksFor() : present().isRefuted();
            if (scale.drift() > DRIFT_LOOKED_AT) {
                scale.shrink(clustered.covariance(), refinement.add(beams, pose));
            }
            scale.see(pose, clustered.covariance(), tracking && monitor.isPlausible());
        }
        trusted &= !lost;
        updatesSinceSearch++;
        PoseEstimate estimate =
                tracking ? tracked(beams, motion, clustered, pose) : found(beams, motion, clustered, pose);
        newest = estimate.hypotheses().getFirst();
        filter.resampleIfDue();
        if (!tracking && rivals.count() > 0 && rivals.share(newest.mapFromBase(), NEAR, NEARLY) < 1 - SURE) {
            filter.inject(rivals.best());
        }
        if (!tracking && estimate.quality() == Quality.LOCALIZED) {
            track();
        }
        return estimate;
    }

    /// How much a scan counts: little where the map explains little of what is seen, as it would pull the pose to where
    /// something else fits by chance. Then odometry knows better.
    private double trust() {
        return tracking ? Math.clamp((monitor.explained() - LITTLE_EXPLAINED) / ENOUGH_MORE, LEAST_TRUST, 1) : 1;
    }

    /// What tells whether the present pose is right.
    private PoseEvidence present() {
        return tracking ? monitor : evidence;
    }

    /// From now on the pose is followed: other places must do much to be believed.
    private void track() {
        tracking = true;
        monitor.trust();
        challengers.clear();
        rivals.clear();
    }

    private void move(Pose2d odomFromBase, Pose2d reported, Pose2d motion) {
        if (tracking && newest != null && Math.hypot(reported.x(), reported.y()) > BROKEN) {
            breakOff(newest.mapFromBase());
        }
        double theta = newest == null ? 0 : newest.mapFromBase().theta();
        double more = tracking ? scale.move(reported, theta) : 0;
        if (scale.isWrong()) {
            filter.move(Pose2d.ORIGIN, motion, more);
        } else {
            filter.move(this.odomFromBase, odomFromBase, more);
        }
    }

    /// Odometry says what no robot does between two scans: it may as well be where it was.
    private void breakOff(Pose2d before) {
        tracking = false;
        trusted = false;
        evidence.restart();
        scale.restart();
        challengers.clear();
        rivals.clear();
        filter.inject(before);
        updatesSinceSearch = MOST_UPDATES_BETWEEN_SEARCHES;
    }

    /// The estimate while it is not known to be anywhere, or not for long enough.
    private PoseEstimate found(Beams beams, Pose2d motion, PoseEstimate clustered, Pose2d pose) {
        if (rivals.count() > 0) {
            rivals.follow(motion, settings.odometry().covariance(motion), beams);
            if (!rivals.hasNear(pose, NEAR, NEARLY)) {
                rivals.add(pose, 0);
            }
        }
        if (beams.count() >= FEWEST_BEAMS && searchIsDue()) {
            lookElsewhere(beams, pose);
        }
        return judged(clustered, pose);
    }

    /// The estimate while it is followed.
    private PoseEstimate tracked(Beams beams, Pose2d motion, PoseEstimate clustered, Pose2d pose) {
        double step = Math.hypot(motion.x(), motion.y()) + METERS_PER_RADIAN * Math.abs(motion.theta());
        challengers.follow(motion, settings.odometry().covariance(motion), step, beams, pose);
        List<Pose2d> winner = challengers.winner(pose, 2 * scale.drift(), monitor.explained(), lost);
        if (!winner.isEmpty()) {
            Pose2d right = winner.getFirst();
            filter.start(PoseEstimate.of(right, AlternativeHypotheses.SPREAD));
            challengers.clear();
            scale.restart();
            monitor.restart();
            lost = false;
            return judged(filter.estimate(), right);
        }
        if (beams.count() >= FEWEST_BEAMS && challengeIsDue()) {
            challenge(beams, pose);
        }
        return judged(clustered, pose);
    }

    private boolean challengeIsDue() {
        return lost
                ? updatesSinceSearch >= searchAfter
                : (misfits.isDoubtful() && updatesSinceSearch >= MOST_UPDATES_BETWEEN_SEARCHES)
                        || (monitor.isDoubtful() && updatesSinceSearch >= 2 * MOST_UPDATES_BETWEEN_SEARCHES);
    }

    private void challenge(Beams beams, Pose2d pose) {
        updatesSinceSearch = 0;
        searchAfter = Math.min(searchAfter + 1, MOST_UPDATES_BETWEEN_SEARCHES);
        misfits.settle();
        double least = search.score(beams, pose) - (lost ? ABOUT_THE_SAME : 0);
        for (GlobalSearch.Candidate candidate : search.candidates(beams, CANDIDATES)) {
            if (candidate.score() > least && !candidate.mapFromBase().isNear(pose, NEAR, NEARLY)) {
                challengers.add(candidate.mapFromBase());
            }
        }
    }

    /// Soon when it is lost, then less and less often; when it is about to be sure for the first time since; now and
    /// then when it is not; and when it is sure but scans have become worse.
    private boolean searchIsDue() {
        if (lost) {
            return updatesSinceSearch >= searchAfter;
        }
        if (rivals.count() > 1) {
            return false;
        }
        return trusted ? misfits.isDoubtful() : updatesSinceSearch >= Math.min(searchAfter, UPDATES_BEFORE_TRUST);
    }

    /// Takes up as rivals where else on the map the scan fits as well as here, or better; where it is sure, only
    /// better. Where it is not lost, they have to be better for a while.
    private void lookElsewhere(Beams beams, Pose2d pose) {
        updatesSinceSearch = 0;
        searchAfter = Math.min(searchAfter + 1, MOST_UPDATES_BETWEEN_SEARCHES);
        double least = search.score(beams, pose) - (trusted ? 0 : ABOUT_THE_SAME);
        rivals.add(pose, 0);
        int before = rivals.count();
        for (GlobalSearch.Candidate candidate : search.candidates(beams, CANDIDATES)) {
            if (candidate.score() > least && !candidate.mapFromBase().isNear(pose, NEAR, NEARLY)) {
                rivals.add(candidate.mapFromBase(), lost ? 0 : DOUBT);
            }
        }
        misfits.settle();
        boolean alone = !lost && rivals.count() == before;
        if (alone) {
            rivals.clear();
        }
        outlasted = lost ? 0 : outlasted + 1;
        if (alone || outlasted > ENOUGH_OUTLASTED) {
            trusted = true;
            searchAfter = 1;
            outlasted = 0;
        }
    }

    /// Particles that scatter while nothing is seen fall into clusters, each of which is narrower than what is known:
    /// then the wheels alone tell, from where something was seen last.
    private PoseEstimate seen(PoseEstimate clustered, Pose2d motion, boolean something) {
        blind = something ? 0 : blind + 1;
        Hypothesis before = newest;
        if (something || before == null) {
            return clustered;
        }
        Pose2d pose = before.mapFromBase().compose(motion);
        var grown = before.covariance()
                .plus(settings.odometry()
                        .covariance(motion)
                        .turned(before.mapFromBase().theta()));
        var moved = new Hypothesis(before.weight(), pose, grown);
        return new PoseEstimate(pose, grown, List.of(moved), clustered.confidence(), clustered.quality());
    }

    private PoseEstimate judged(PoseEstimate clustered, Pose2d pose) {
        var clusters = new ArrayList<>(clustered.hypotheses());
        Hypothesis first = clusters.getFirst();
        clusters.set(0, new Hypothesis(first.weight(), pose, first.covariance()));
        List<Hypothesis> hypotheses = tracking ? challengers.join(clusters) : rivals.join(clusters, NEAR, NEARLY);
        double share = hypotheses.getFirst().weight();
        double likely = Math.clamp(share, 0, 1) * present().probability() * Math.pow(BLIND_TRUST, blind);
        boolean plausible =
                tracking ? monitor.isPlausible() && !monitor.isDoubtful() : trusted && evidence.isPlausible();
        boolean sure = plausible
                && blind < BLIND_AND_SURE
                && share >= SURE
                && Math.max(first.covariance().positionDeviation(), scale.drift()) <= PRECISE;
        boolean astray = lost || fitNow < LEAST_FIT_NOW || blind >= BLIND_AND_LOST;
        Quality quality = astray ? Quality.LOST : sure ? Quality.LOCALIZED : Quality.AMBIGUOUS;
        double confidence = switch (quality) {
            case LOCALIZED -> likely;
            case AMBIGUOUS -> MOST_AMBIGUOUS * likely;
            case LOST -> MOST_LOST * likely;
        };
        return new PoseEstimate(pose, first.covariance(), hypotheses, confidence, quality);
    }

    /// The particles as they are now.
    public ParticleCloud particles() {
        return filter.cloud();
    }

    /// How many particles there are now.
    public int particleCount() {
        return filter.count();
    }

    private void restart(boolean anywhere) {
        this.anywhere = anywhere;
        fresh = true;
        lost = anywhere;
        updatesSinceSearch = 0;
        searchAfter = 1;
        trusted = !anywhere;
        outlasted = 0;
        fitNow = 1;
        misfits.restart();
        evidence.restart();
        monitor.restart();
        tracking = false;
        challengers.clear();
        scale.restart();
        blind = 0;
        newest = null;
        rivals.clear();
    }

    /// Particles where the scan could have been taken, and some anywhere.
    private void scatter(Beams beams) {
        anywhere = false;
        rivals.clear();
        List<Pose2d> candidates = beams.count() < FEWEST_BEAMS
                ? List.of()
                : search.candidates(beams, CANDIDATES).stream()
                        .map(GlobalSearch.Candidate::mapFromBase)
                        .toList();
        candidates.forEach(candidate -> rivals.add(candidate, 0));
        filter.scatter(candidates);
    }

    /// Takes up what became of the beams at the estimate.
    private void judge(Fates fates) {
        evidence.add(fates.hits(), fates.through(), fates.shorter());
        monitor.add(fates.hits(), fates.through(), fates.shorter());
        int reaching = fates.hits() + fates.through();
        if (reaching >= FEWEST_BEAMS) {
            fitNow = (double) fates.hits() / reaching;
        }
        misfits.add(fates.through(), fates.reported());
    }
}
