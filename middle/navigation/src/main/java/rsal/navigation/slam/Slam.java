package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.scanmatch.Cloud;
import rsal.navigation.scanmatch.CorrelativeMatcher;
import rsal.navigation.scanmatch.CorrelativeMatcher.Spot;
import rsal.navigation.scanmatch.CorrelativeMatcher.Window;
import rsal.navigation.scanmatch.LineMatcher;
import rsal.navigation.scanmatch.Match;

/// Maps a place and finds its way in it at once, from a laser and odometry: each scan is matched with those
/// just before it, scans that lie some way apart are kept as the nodes of a graph, places that are seen again
/// close loops ([LoopCloser]), and the graph is fitted to all of that ([PoseGraph]). Loops that contradict others
/// are refused, until more frames tell them ([Refused]). After E. Olson, Robust and Efficient Robotic Mapping (PhD
/// thesis, MIT 2008), and W. Hess, D. Kohler, H. Rapp, D. Andor, Real-Time Loop Closure in 2D LIDAR SLAM (ICRA
/// 2016).
///
/// The first scan kept is where the odometry says; the map's frame begins there. The same input gives the
/// same map. It keeps at most [Settings#mostFrames] scans, and after that only finds its way, by those that it
/// kept near where it is: beyond them it is lost ([Tracking]). Not safe for several threads.
///
/// Longer than 500 lines, since each step works on all of its state: the graph, the frames and where it is.
public final class Slam {
    private static final double LEAST_SCORE = 0.35; // of a search, to be worth refining
    private static final double LEAST_PAIRS = 0.35; // of a scan, to be believed
    private static final double WELL = 0.5; // of a scan, to look no farther than wheels err as a rule
    private static final double LEAST_SCORE_ALONE = 0.2; // of a search, where nothing else is found
    private static final double LEAST_ALONE = 0.3; // of a scan, where nothing else is found
    private static final double RIVAL = 0.6; // share of the score from which another place is one
    private static final double BETTER = 0.1; // that one farther off scores more, to be believed instead
    private static final double WIDE = 0.6; // rad; searched then
    private static final double DOUBTED = 3; // times what wheels err as a rule, when what is seen fits nowhere
    private static final int FEWEST = 15; // points of a scan, to be missed on the map
    private static final double TRUST = 0.15; // in odometry; see Window
    private static final double SEARCHED = 0.12; // m; cells in which scans are thinned for the search
    private static final double APART = 0.4; // m; a refinement doesn't go farther from what was found
    private static final double HELD = 0.1; // m; deviation of what was found
    private static final double TURNED = 0.15; // rad
    private static final CorrelativeMatcher.Settings SEARCH = new CorrelativeMatcher.Settings(0.05, 0.08, 4);
    private static final double MOST_BENT =
            GraphResidual.TOO_MUCH * GraphResidual.TOO_MUCH; // the same of a step by odometry alone
    private static final double LONG_DISTANCE = 4; // of usual steps: the wheels were not lifted
    private static final double MISFIT = 16; // square of a loop's error in deviations that is too much
    private static final double FAR = 1000; // m; between robots, as no way led from one to the other
    // how scans err beside what their points tell
    private static final double OWN_METERS = 0.02;
    private static final double OWN_RADIANS = 0.003;

    private final Settings settings;
    private final LoopCloser loops;
    private final List<GraphNode> frames = new ArrayList<>();
    private final List<Relation> relations = new ArrayList<>();
    private final Refused refused = new Refused();
    private List<Pose2d> poses = new ArrayList<>();
    private int fits;
    private int blindFrom = Integer.MAX_VALUE; // the first frame that was kept without a match since a loop closed
    private Tracking tracking;

    private Pose2d lastOdomFromBase = Pose2d.ORIGIN;
    private double traveled;
    private Located last = new Located(0, Pose2d.ORIGIN); // of the last scan
    private int base; // the frame in whose frame the scans are that the next ones are matched with
    private Optional<LineMatcher> lines = Optional.empty();
    private Optional<CorrelativeMatcher> search = Optional.empty();

    /// @param maxRange hits farther than this are not matched [m]
    /// @param everyMeters how far apart scans are that are kept
    /// @param everyRadians how far apart their headings are
    /// @param odometry how wheels err
    /// @param recent how many scans that were kept the next is matched with
    /// @param closesLoops whether places are known again
    /// @param mostFrames scans kept at most
    public record Settings(
            double maxRange,
            double everyMeters,
            double everyRadians,
            Wheels odometry,
            int recent,
            boolean closesLoops,
            int mostFrames) {
        public static final Settings DEFAULT = new Settings(25, 0.5, 0.35, Wheels.ROUGH, 10, true, 10_000);

        public Settings {
            if (!(maxRange > 0 && everyMeters > 0 && everyRadians > 0 && recent >= 1 && mostFrames >= 2)) {
                throw new IllegalArgumentException(
                        ("The longest range '%s', distance '%s' and turn '%s' between scans must be more than 0, the"
                                        + " scans to match with %d at least 1 and those kept %d 2.")
                                .formatted(maxRange, everyMeters, everyRadians, recent, mostFrames));
            }
        }

        /// The same that looks at nothing beyond a range [m].
        public Settings within(double range) {
            return new Settings(range, everyMeters, everyRadians, odometry, recent, closesLoops, mostFrames);
        }
    }

    /// How odometry errs between two scans, as deviations.
    ///
    /// @param metersPerMeter of the way
    /// @param radiansPerRadian of the turn
    /// @param radiansPerMeter of the turn, by the way
    public record Wheels(double metersPerMeter, double radiansPerRadian, double radiansPerMeter) {
        /// As small robots on carpets do.
        public static final Wheels ROUGH = new Wheels(0.06, 0.08, 0.04);

        Covariance2d covariance(Pose2d motion) {
            double meters = 0.02 + metersPerMeter * Math.hypot(motion.x(), motion.y());
            return Covariance2d.ofDeviations(meters, meters, radians(motion));
        }

        double radians(Pose2d motion) {
            return 0.01
                    + radiansPerRadian * Math.abs(motion.theta())
                    + radiansPerMeter * Math.hypot(motion.x(), motion.y());
        }
    }

    /// Where a scan was taken, seen from one that was kept, so that it stays right when the graph is fitted.
    public record Located(int frame, Pose2d frameFromBase) {}

    public Slam(Settings settings) {
        this.settings = settings;
        this.loops = new LoopCloser(frames);
        this.tracking = Tracking.start(settings.odometry());
    }

    /// Takes one scan.
    ///
    /// @param odomFromBase what the wheels say
    /// @throws IllegalArgumentException when the pose is not finite
    public Located add(Pose2d odomFromBase, LaserScan scan) {
        if (!odomFromBase.isFinite()) {
            throw new IllegalArgumentException("'%s' can't be odometry.".formatted(odomFromBase));
        }
        Cloud cloud = Cloud.of(scan, settings.maxRange());
        if (frames.isEmpty()) {
            poses.add(odomFromBase);
            keep(new GraphNode(odomFromBase, 0, scan, cloud));
            lastOdomFromBase = odomFromBase;
            return last;
        }
        Pose2d motion = lastOdomFromBase.inverse().compose(odomFromBase);
        lastOdomFromBase = odomFromBase;
        traveled += Math.hypot(motion.x(), motion.y());
        Pose2d guess = last.frameFromBase().compose(motion);
        Optional<Match> match = match(cloud, guess, motion);
        track(cloud, motion, match);
        Pose2d frameFromBase = match.map(m -> joined(guess, motion, m)).orElse(guess);
        last = new Located(base, frameFromBase);
        boolean apart = Math.hypot(frameFromBase.x(), frameFromBase.y()) >= settings.everyMeters()
                || Math.abs(frameFromBase.theta()) >= settings.everyRadians();
        if (apart && frames.size() >= settings.mostFrames()) {
            turnToNearest();
        } else if (apart) {
            Pose2d reported = frames.get(base).odomFromBase().inverse().compose(odomFromBase);
            int number = frames.size();
            poses.add(poses.get(base).compose(frameFromBase));
            Covariance2d wheels = settings.odometry().covariance(reported);
            relations.add(new Relation(base, number, reported, wheels, Relation.Source.ODOMETRY));
            match.ifPresent(m -> relations.add(
                    new Relation(base, number, m.aFromB(), honest(m.covariance()), Relation.Source.SCANS)));
            Covariance2d doubted = isComparable(cloud) ? wheels.times(DOUBTED * DOUBTED) : wheels;
            loops.step(
                    base,
                    number,
                    frameFromBase,
                    match.map(m -> Gauss.joined(wheels, honest(m.covariance()))).orElse(doubted));
            keep(new GraphNode(odomFromBase, traveled, scan, cloud));
            if (match.isEmpty()) {
                tracking = tracking.mappedBlindly();
                blindFrom = Math.min(blindFrom, number);
            }
            if (settings.closesLoops()) {
                close(loops.look(number, poses));
            }
        }
        return last;
    }

    private void track(Cloud cloud, Pose2d motion, Optional<Match> match) {
        double axes = poses.get(base).theta();
        Tracking moved = tracking.moved(motion);
        tracking = match.map(m -> moved.matched(
                        honest(m.covariance()).turned(axes), settings.odometry().covariance(Pose2d.ORIGIN), m.score()))
                .orElseGet(() -> moved.missed(isComparable(cloud)));
    }

    /// Whether a scan shows something, and there is something to match it with.
    private boolean isComparable(Cloud cloud) {
        return lines.isPresent() && cloud.count() >= FEWEST;
    }

    /// How sure it is of where the last scan was taken.
    public Tracking tracking() {
        return tracking;
    }

    /// What the match says and, along what it can't tell, the wheels.
    private Pose2d joined(Pose2d guess, Pose2d motion, Match match) {
        return Gauss.mean(guess, settings.odometry().covariance(motion), match.aFromB(), honest(match.covariance()));
    }

    static Covariance2d honest(Covariance2d c) {
        double place = OWN_METERS * OWN_METERS;
        return new Covariance2d(
                c.xx() + place,
                c.xy(),
                c.xTheta(),
                c.yy() + place,
                c.yTheta(),
                c.thetaTheta() + OWN_RADIANS * OWN_RADIANS);
    }

    /// Where a scan that matches badly, or not, matches better though wheels hardly ever err so much, it does: a turn
    /// that they mistake once, by more than loops are searched for, would bend the map behind it for good.
    private Optional<Match> match(Cloud cloud, Pose2d guess, Pose2d motion) {
        if (lines.isEmpty() || search.isEmpty()) {
            return Optional.empty();
        }
        double meters = 0.1 + 3 * settings.odometry().metersPerMeter() * Math.hypot(motion.x(), motion.y());
        double radians = 3 * settings.odometry().radians(motion);
        var window = new Window(Math.min(1.5, meters), Math.min(0.8, radians), TRUST);
        Pose2d near = search.orElseThrow()
                .match(cloud.thinned(SEARCHED), guess, window, LEAST_SCORE)
                .map(Match::aFromB)
                .orElse(guess);
        Optional<Match> match = refined(cloud, near, LEAST_PAIRS);
        if (match.isPresent() && match.get().score() >= WELL) {
            return match;
        }
        var wide = new Window(window.meters(), Math.max(WIDE, window.radians()), TRUST);
        return farther(cloud, guess, wide, match.map(m -> m.score() + BETTER).orElse(LEAST_ALONE))
                .or(() -> match);
    }

    /// Fits well or, as who went through a door sees little of what was seen before, far better than anywhere else.
    private Optional<Match> farther(Cloud cloud, Pose2d guess, Window window, double leastScore) {
        CorrelativeMatcher matcher = search.orElseThrow();
        Cloud thinned = cloud.thinned(SEARCHED);
        return matcher.match(thinned, guess, window, LEAST_SCORE_ALONE).flatMap(found -> {
            var there = new Spot(found.aFromB(), APART, TURNED);
            double rival = RIVAL * found.score();
            return refined(cloud, found.aFromB(), leastScore)
                    .filter(m -> (m.score() >= WELL && found.score() >= LEAST_SCORE)
                            || matcher.matchElsewhere(thinned, guess, window, rival, there)
                                    .isEmpty());
        });
    }

    private Optional<Match> refined(Cloud cloud, Pose2d found, double leastScore) {
        return lines.orElseThrow()
                .match(cloud, found)
                .filter(m -> m.score() >= leastScore)
                .map(m -> isAt(found, m) ? m : held(found, m))
                .filter(m -> isAt(found, m));
    }

    private static boolean isAt(Pose2d found, Match match) {
        return match.aFromB().isNear(found, APART, TURNED);
    }

    /// A refinement that stays where it began in what it can't tell: along parallel walls it may slide by a meter.
    private static Match held(Pose2d found, Match match) {
        var loosely = Covariance2d.ofDeviations(HELD, HELD, TURNED);
        Pose2d held = Gauss.mean(found, loosely, match.aFromB(), match.covariance());
        return new Match(held, match.covariance(), match.score());
    }

    private void keep(GraphNode frame) {
        frames.add(frame);
        base = frames.size() - 1;
        last = new Located(base, Pose2d.ORIGIN);
        matchWith(LocalMap.of(frames, poses, base - settings.recent() + 1, base, base));
    }

    /// The scans that were kept nearest to where the robot is are those that the next are matched with.
    private void turnToNearest() {
        Pose2d here = pose(last);
        int[] nearest = IntStream.range(0, frames.size())
                .boxed()
                .sorted(Comparator.comparingDouble(i -> away(here, poses.get(i))))
                .limit(settings.recent())
                .mapToInt(i -> i)
                .toArray();
        if (nearest[0] != base) {
            base = nearest[0];
            last = new Located(base, poses.get(base).inverse().compose(here));
            matchWith(LocalMap.of(frames, poses, IntStream.of(nearest), base));
        }
    }

    /// Scans that look elsewhere see less of the same.
    private static double away(Pose2d a, Pose2d b) {
        return a.distanceTo(b) + Math.abs(Angles.difference(a.theta(), b.theta()));
    }

    private void matchWith(Cloud around) {
        lines = around.count() == 0 ? Optional.empty() : Optional.of(new LineMatcher(around));
        search = around.count() == 0 ? Optional.empty() : Optional.of(new CorrelativeMatcher(around, SEARCH));
    }

    /// Those that would bend others are refused.
    void close(List<Relation> closing) {
        if (closing.isEmpty()) {
            return;
        }
        List<Relation> contradicting =
                closing.stream().filter(this::contradicts).toList();
        if (contradicting.isEmpty()) {
            relations.addAll(closing);
            fit();
            believe(closing);
            return;
        }
        var all = new ArrayList<>(relations);
        all.addAll(closing);
        List<Pose2d> fitted = PoseGraph.fitFromAfar(poses, all).poses();
        fits++;
        if (largeResiduals(all, fitted) <= largeResiduals(relations, poses) // those that are right bend no others
                && !bendsMore(all, fitted)) {
            relations.addAll(closing);
            poses = new ArrayList<>(fitted);
            believe(closing);
            return;
        }
        List<Relation> fitting =
                closing.stream().filter(loop -> !contradicts(loop)).toList();
        close(fitting);
        if (fitting.isEmpty()) { // else it is where the graph says
            refused.add(contradicting, frames.size() - 1);
            reconsider();
        }
    }

    private boolean contradicts(Relation loop) {
        return square(loop) > PoseGraph.LOOP_PHI;
    }

    private void believe(List<Relation> closing) {
        closing.forEach(loops::trust);
        if (closing.stream().anyMatch(r -> r.from() < blindFrom)) {
            tracking = tracking.closed();
            blindFrom = Integer.MAX_VALUE;
        }
    }

    /// Believes loops that were refused once they outweigh those that they contradict, and scans that were matched with
    /// those just before them don't; then these others are dropped.
    private void reconsider() {
        List<Relation> agreeing = refused.agreeing(poses);
        if (agreeing.isEmpty()) {
            return;
        }
        var all = new ArrayList<>(relations);
        all.addAll(agreeing);
        List<Pose2d> fitted = PoseGraph.fitFromAfar(poses, all).poses();
        List<Relation> wrong = all.stream()
                .filter(r -> r.source() != Relation.Source.ODOMETRY && isStrained(r, fitted) && !isStrained(r, poses))
                .toList();
        boolean loopsOnly = wrong.stream().allMatch(r -> r.source() == Relation.Source.LOOP);
        if (loopsOnly
                && Refused.outweigh(agreeing, wrong)
                && agreeing.stream().noneMatch(r -> isStrained(r, fitted))
                && !bendsMore(all, fitted)) {
            relations.removeAll(wrong);
            wrong.forEach(loops::distrust);
            relations.addAll(agreeing);
            refused.forget(agreeing);
            poses = new ArrayList<>(fitted);
            fit();
            believe(agreeing);
        }
    }

    /// How many relations hardly fit, besides what the wheels say.
    private static long largeResiduals(List<Relation> relations, List<Pose2d> poses) {
        return relations.stream()
                .filter(r -> r.source() != Relation.Source.ODOMETRY && isStrained(r, poses))
                .count();
    }

    /// How many steps lie so that their odometry is hardly possible, though nothing else tells of them and the wheels
    /// turned for long: where a log has a gap, say. A robot that was carried tells of no such way.
    private static long bent(List<Relation> relations, List<Pose2d> poses, double leastDistance) {
        Set<Integer> seen = relations.stream()
                .filter(r -> r.source() == Relation.Source.SCANS)
                .map(Relation::to)
                .collect(Collectors.toSet());
        return relations.stream()
                .filter(r -> r.source() == Relation.Source.ODOMETRY)
                .filter(r -> !seen.contains(r.to()))
                .filter(r -> Math.hypot(r.fromFromTo().x(), r.fromFromTo().y()) >= leastDistance)
                .filter(r -> PoseGraph.square(r, poses.get(r.from()), poses.get(r.to())) > MOST_BENT)
                .count();
    }

    private boolean bendsMore(List<Relation> all, List<Pose2d> fitted) {
        double leastDistance = LONG_DISTANCE * settings.everyMeters();
        return bent(all, fitted, leastDistance) > bent(relations, poses, leastDistance);
    }

    private static boolean isStrained(Relation relation, List<Pose2d> poses) {
        return PoseGraph.square(relation, poses.get(relation.from()), poses.get(relation.to())) > MISFIT;
    }

    private void fit() {
        poses = new ArrayList<>(PoseGraph.fit(poses, relations).poses());
        fits++;
    }

    /// Looks at all scans once more, now that it is known where they were taken: those that see the same are
    /// matched with each other, relations that don't fit are dropped, and all is fitted again.
    ///
    /// @param rounds how often; 2 do
    public void polish(int rounds) {
        for (int round = 0; round < rounds && settings.closesLoops(); round++) {
            relations.removeIf(r -> r.source() == Relation.Source.LOOP);
            relations.addAll(loops.everywhere(poses));
            fit();
            relations.removeIf(r -> r.source() == Relation.Source.LOOP && isStrained(r, poses));
            fit();
        }
    }

    /// Adds the map of another robot to this one, wherever it began: finds how they lie to each other
    /// ([Merging]), then fits both to what their scans have in common, and believes it if they then share
    /// enough and little speaks against it ([MapOverlap]). The other stays as it is.
    ///
    /// @return how they lie to each other; nothing changes when that can't be told, or not for sure
    /// @throws IllegalArgumentException when they hold too many scans together
    public Merge merge(Slam other) {
        return merge(other, false);
    }

    /// The same, but it also believes the other map when what one saw contradicts what the other did, as where
    /// something was moved in between: [MapOverlap#isContradicted] tells.
    public Merge mergeDespiteContradictions(Slam other) {
        return merge(other, true);
    }

    private Merge merge(Slam other, boolean despiteContradictions) {
        if (frames.size() + other.frames.size() > settings.mostFrames()) {
            throw new IllegalArgumentException("The maps hold %d and %d scans; together at most %d."
                    .formatted(frames.size(), other.frames.size(), settings.mostFrames()));
        }
        if (frames.isEmpty() || other.frames.isEmpty()) {
            return new Merge.Apart();
        }
        Pose2d mapFromOther;
        switch (Merging.align(frames, poses, other.frames, other.poses)) {
            case Merging.One(Pose2d place) -> mapFromOther = place;
            case Merging.Ambiguous(Pose2d one, Pose2d rival) -> {
                return new Merge.Ambiguous(one, rival);
            }
            case Merging.Nowhere _ -> {
                return new Merge.Apart();
            }
        }
        int first = frames.size();
        List<Pose2d> posesBefore = List.copyOf(poses);
        List<Relation> relationsBefore = List.copyOf(relations);
        int fitsBefore = fits;
        for (int i = 0; i < other.frames.size(); i++) {
            GraphNode frame = other.frames.get(i);
            frames.add(new GraphNode(
                    frame.odomFromBase(), traveled + FAR + frame.traveled(), frame.scan(), frame.cloud()));
            poses.add(mapFromOther.compose(other.poses.get(i)));
        }
        other.relations.forEach(r -> relations.add(
                new Relation(r.from() + first, r.to() + first, r.fromFromTo(), r.covariance(), r.source())));
        polish(2);
        MapOverlap shared = MapOverlap.of(frames, poses, first);
        Pose2d mapFromOtherNow = poses.getLast().compose(other.poses.getLast().inverse());
        if (!shared.isEnough() || (shared.isContradicted() && !despiteContradictions)) {
            frames.subList(first, frames.size()).clear();
            poses = new ArrayList<>(posesBefore);
            relations.clear();
            relations.addAll(relationsBefore);
            fits = fitsBefore;
            return shared.isEnough() ? new Merge.Contradicted(mapFromOtherNow, shared) : new Merge.Apart();
        }
        traveled += FAR + other.traveled;
        return new Merge.Done(mapFromOtherNow, shared);
    }

    /// How many scans were kept.
    public int frameCount() {
        return frames.size();
    }

    /// How often the graph was fitted; after that, poses may have jumped.
    public int fits() {
        return fits;
    }

    /// Where the scans that were kept were taken, by number.
    public List<Pose2d> poses() {
        return List.copyOf(poses);
    }

    public Pose2d pose(Located located) {
        return poses.get(located.frame()).compose(located.frameFromBase());
    }

    /// What is known of how they lie to each other.
    public List<Relation> relations() {
        return List.copyOf(relations);
    }

    /// How far off a relation is after the last fit, in deviations.
    public double residual(Relation relation) {
        return Math.sqrt(square(relation));
    }

    private double square(Relation relation) {
        return PoseGraph.square(relation, poses.get(relation.from()), poses.get(relation.to()));
    }

    /// How much the last fit bends what was told of the way from each scan that was kept to the next.
    public GraphResidual graphResidual() {
        return GraphResidual.of(relations, poses);
    }

    /// Where scans contradict each other most, by the last fit; empty when there are too few to tell. Takes some
    /// seconds for thousands of scans.
    public Optional<FreeSpaceViolation> contradiction() {
        return FreeSpaceViolation.of(frames, poses);
    }

    /// Whether scans say that the robot turned as its wheels do.
    public TurnAgreement turns() {
        return TurnAgreement.of(relations);
    }

    /// Difference of two headings of a relation [rad], told and fitted.
    public double headingResidual(Relation relation) {
        Pose2d is = poses.get(relation.from()).inverse().compose(poses.get(relation.to()));
        return Math.abs(Angles.difference(is.theta(), relation.fromFromTo().theta()));
    }

    /// The scans that were kept, where they were taken.
    public List<PosedScan> posedScans() {
        var posed = new ArrayList<PosedScan>();
        for (int i = 0; i < frames.size(); i++) {
            posed.add(new PosedScan(poses.get(i), frames.get(i).scan()));
        }
        return posed;
    }

    /// @throws IllegalArgumentException when there is no scan yet, or the map would be too large
    public OccupancyGrid map(ScanMapper.Settings how) {
        return ScanMapper.draw(posedScans(), how);
    }
}
