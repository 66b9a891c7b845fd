package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.player.message.Localize;
import rsal.player.message.Pose;
import rsal.player.wire.Address;

/// A robot's own localizer, behind `localize`. Player's amcl says something only when it has looked again, after
/// 0.2 m or 30°: in between, estimates go with the odometry, but not for ever: who says nothing on a long way
/// is stale.
final class PlayerLocalizer extends PlayerSensor<PoseEstimate> implements Localizer {
    private static final int REMEMBERED = 50; // odometry, to know where the robot was when it was localized
    private static final double SURE = 0.5; // m, rad: with deviations of less a robot is localized
    private static final double LONG_DISTANCE = 3; // m, on which one that works says something
    private static final double LONG_TURN = 2 * Math.PI; // rad; the same
    private static final Duration LOOK_AGAIN = Duration.ofMillis(500); // at particles

    private final RemoteServer server;
    private final InstantSource clock;
    private final Deque<Stamped<Odometry>> driven = new ArrayDeque<>();
    private @Nullable PoseEstimate known;
    private Pose2d odomFromKnown = Pose2d.ORIGIN;
    private double distance; // driven since then [m]
    private double turn; // to either side [rad]
    private Optional<Stamped<ParticleCloud>> particles = Optional.empty();
    private Instant asked = Instant.MIN; // for particles

    PlayerLocalizer(DeviceInfo info, Address address, RemoteServer server, DriveBase base, InstantSource clock) {
        super(info, address, "map");
        this.server = server;
        this.clock = clock;
        base.subscribe(this::drove);
    }

    private void drove(Stamped<Odometry> odometry) {
        Pose2d odomFromBase = odometry.value().odomFromBase();
        Pose2d before =
                driven.isEmpty() ? odomFromBase : driven.getLast().value().odomFromBase();
        distance += before.distanceTo(odomFromBase);
        turn += Math.abs(Angles.difference(before.theta(), odomFromBase.theta()));
        driven.addLast(odometry);
        if (driven.size() > REMEMBERED) {
            driven.removeFirst();
        }
        PoseEstimate last = known;
        if (last == null) {
            return;
        }
        if (distance > LONG_DISTANCE || turn > LONG_TURN) {
            health(new Health.Stale("It has not looked for %.0f m or a whole turn.".formatted(LONG_DISTANCE)));
        } else {
            publish(odometry.time(), last.moved(odomFromKnown.inverse().compose(odomFromBase)));
        }
    }

    @Override
    boolean isSteady() {
        return false;
    }

    @Override
    Optional<PoseEstimate> read(Record body) {
        if (!(body instanceof Localize.Hypotheses reported)) {
            return Optional.empty();
        }
        List<Hypothesis> all = hypotheses(reported.hypotheses());
        return all.isEmpty() ? Optional.empty() : Optional.of(estimate(all));
    }

    /// @param all heaviest first
    private static PoseEstimate estimate(List<Hypothesis> all) {
        Hypothesis best = all.getFirst();
        return new PoseEstimate(
                best.mapFromBase(), best.covariance(), all, Math.clamp(best.weight(), 0, 1), quality(best));
    }

    /// Those that are numbers, heaviest first, their weights 1 together at most.
    private static List<Hypothesis> hypotheses(List<Localize.Hypothesis> reported) {
        var all = new ArrayList<Hypothesis>();
        for (Localize.Hypothesis one : reported) {
            Covariance2d covariance = one.spread();
            Pose2d mapFromBase = one.mapFromBase().to2d();
            if (mapFromBase.isFinite() && covariance.isFinite() && one.weight() >= 0 && one.weight() < 1e9) {
                all.add(new Hypothesis(one.weight(), mapFromBase, covariance));
            }
        }
        double sum = all.stream().mapToDouble(Hypothesis::weight).sum();
        return all.stream()
                .map(one -> sum > 1 ? new Hypothesis(one.weight() / sum, one.mapFromBase(), one.covariance()) : one)
                .sorted(Comparator.comparingDouble(Hypothesis::weight).reversed())
                .toList();
    }

    private static Quality quality(Hypothesis best) {
        boolean sure = best.covariance().positionDeviation() < SURE
                && Math.sqrt(Math.max(0, best.covariance().thetaTheta())) < SURE;
        if (!sure) {
            return Quality.LOST;
        }
        return best.weight() > 0.5 ? Quality.LOCALIZED : Quality.AMBIGUOUS;
    }

    /// A localizer tells nothing before its robot moves, and one that others use may have begun long ago.
    @Override
    public List<Integer> questions() {
        return List.of(Localize.PARTICLES);
    }

    @Override
    public void answered(Record body) {
        if (body instanceof Localize.Particles reported) {
            Moments.of(reported.particles()).ifPresent(best -> believe(estimate(List.of(best)), clock.instant()));
        }
    }

    @Override
    public void take(Instant time, Record body) {
        read(body).ifPresent(estimate -> believe(estimate, time));
    }

    /// What is told of the same time as the newest odometry is part of the next estimate.
    private void believe(PoseEstimate estimate, Instant time) {
        known = estimate;
        odomFromKnown = odomFromBase(time);
        distance = 0;
        turn = 0;
        if (driven.isEmpty() || driven.getLast().time().isBefore(time)) {
            publish(time, estimate);
        }
    }

    /// Where odometry had the robot at a time, or nearest to it.
    private Pose2d odomFromBase(Instant time) {
        return driven.stream()
                .min(Comparator.comparing(
                        odometry -> Duration.between(odometry.time(), time).abs()))
                .map(odometry -> odometry.value().odomFromBase())
                .orElse(Pose2d.ORIGIN);
    }

    /// What is believed is a reading once the server has taken it.
    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        var reported = new Localize.SetPose(Pose.of(belief.mapFromBase()), Localize.sent(belief.covariance()));
        return server.ask(address(), Localize.SET_POSE, Optional.of(reported))
                .thenAccept(_ -> believe(belief, clock.instant()));
    }

    /// Asked for when somebody looks, so that the first look shows none, and at most twice a second.
    @Override
    public Optional<Stamped<ParticleCloud>> particles() {
        Instant now = clock.instant();
        if (asked.isBefore(now.minus(LOOK_AGAIN))) {
            asked = now;
            server.ask(address(), Localize.PARTICLES, Optional.empty())
                    .thenAccept(answer -> particles = answer.filter(Localize.Particles.class::isInstance)
                            .map(Localize.Particles.class::cast)
                            .map(reported -> new Stamped<>(now, "map", cloud(reported.particles()))));
        }
        return particles;
    }

    private static ParticleCloud cloud(List<Localize.Particle> reported) {
        var poses = new float[3 * reported.size()];
        var weights = new float[reported.size()];
        double sum = reported.stream().mapToDouble(Localize.Particle::weight).sum();
        for (int i = 0; i < weights.length; i++) {
            Localize.Particle one = reported.get(i);
            poses[3 * i] = (float) one.mapFromBase().x();
            poses[3 * i + 1] = (float) one.mapFromBase().y();
            poses[3 * i + 2] = (float) one.mapFromBase().theta();
            weights[i] = (float) (sum > 0 ? one.weight() / sum : 1.0 / weights.length);
        }
        return new ParticleCloud(poses, weights);
    }

    @Override
    public void lost(String reason) {
        known = null;
        driven.clear();
        super.lost(reason);
    }
}
