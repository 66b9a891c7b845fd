package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;
import rsal.testkit.DrawnMap;

/// When [Amcl] looks, and what it tells of what it has seen: in numbers. In a hall of 6 m with walls of 0.1 m,
/// from the middle of which they are 2.95 m away.
class AmclJudgementTest {
    private static final LocalizationMap HALL = new LocalizationMap(Seen.hall(60, 60, 0, 0), 0.1, 0.05);
    private static final Pose2d MIDDLE = new Pose2d(3, 3, 0);
    private static final Covariance2d KNOWN = Covariance2d.ofDeviations(0.05, 0.05, 0.02);
    private static final Pose2d STEP = new Pose2d(0.15, 0.02, 0.1);
    private static final double TRUSTED = 1 / (1 + Math.exp(-8)); // by the monitor of who was told where it is

    private final Amcl.Settings settings = Amcl.Settings.of(100, 500);
    private final Amcl amcl = new Amcl(HALL, settings, new SplittableRandom(1));
    private final AtomicInteger asked = new AtomicInteger();
    private Pose2d odometry = new Pose2d(7, -2, 0.4);

    /// Beams that end at the walls ahead, left, behind and right in turn, and then some that go on through
    /// them, or end halfway.
    private static Beams beams(int hits, int through, int shorter) {
        int count = hits + through + shorter;
        var beams = new Beams(new float[count], new float[count], new float[count], new float[count]);
        for (int i = 0; i < count; i++) {
            double range = i < hits ? 2.95 : i < hits + through ? 4.5 : 1.5;
            double direction = i * Math.PI / 2;
            beams.x()[i] = (float) (range * Math.cos(direction));
            beams.y()[i] = (float) (range * Math.sin(direction));
        }
        return beams;
    }

    private PoseEstimate look(Beams beams) {
        return amcl.update(odometry, beams);
    }

    private PoseEstimate blindly() {
        odometry = odometry.compose(STEP);
        return amcl.update(odometry, Seen.NOTHING);
    }

    private boolean isDue(Pose2d motion, Beams beams) {
        return amcl.due(odometry.compose(motion), () -> {
            asked.incrementAndGet();
            return beams;
        });
    }

    private static PoseEstimate belief(Quality quality, double... weights) {
        var hypotheses = new ArrayList<Hypothesis>();
        for (double weight : weights) {
            hypotheses.add(new Hypothesis(weight, MIDDLE, KNOWN));
        }
        return new PoseEstimate(MIDDLE, KNOWN, hypotheses, 1, quality);
    }

    @Test
    void aScanIsDueAfterAWayOrATurn() {
        assertThat(isDue(Pose2d.ORIGIN, beams(8, 0, 0))).as("the first").isTrue();
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        assertThat(isDue(Pose2d.ORIGIN, beams(8, 0, 0))).as("the first again").isTrue();
        look(beams(8, 0, 0));
        assertThat(isDue(new Pose2d(0.099, 0, 0), beams(8, 0, 0))).isFalse();
        assertThat(isDue(new Pose2d(0.06, -0.06, Math.toRadians(5.9)), beams(8, 0, 0)))
                .isFalse();
        assertThat(isDue(new Pose2d(0.101, 0, 0), beams(8, 0, 0))).isTrue();
        assertThat(isDue(new Pose2d(-0.08, 0.08, 0), beams(8, 0, 0))).isTrue();
        assertThat(isDue(new Pose2d(0, 0, Math.toRadians(6.1)), beams(8, 0, 0))).isTrue();
        assertThat(isDue(new Pose2d(0, 0, Math.toRadians(-6.1)), beams(8, 0, 0)))
                .isTrue();
        assertThat(asked).as("nobody needs the beams for that").hasValue(0);
        amcl.startAnywhere();
        assertThat(isDue(Pose2d.ORIGIN, beams(8, 0, 0))).isTrue();
    }

    @Test
    void whileTheWheelsStandOneOfFiveScansIsCompared() {
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        look(beams(8, 0, 0));
        for (int scan = 1; scan <= 12; scan++) {
            assertThat(isDue(Pose2d.ORIGIN, beams(0, 20, 0)))
                    .as("scan %d", scan)
                    .isEqualTo(scan % 5 == 0);
            assertThat(asked).hasValue(scan / 5);
        }
        look(beams(8, 0, 0));
        for (int scan = 1; scan <= 5; scan++) {
            assertThat(isDue(Pose2d.ORIGIN, beams(0, 20, 0)))
                    .as("scan %d after another", scan)
                    .isEqualTo(scan == 5);
        }
    }

    /// More than 3 of 10, of 5 at least that tell anything.
    @ParameterizedTest
    @CsvSource({
        "14, 6, 0, false",
        "13, 7, 0, true",
        "7, 6, 7, false",
        "6, 7, 7, true",
        "0, 0, 20, false",
        "20, 0, 0, false",
        "0, 4, 0, false",
        "0, 5, 0, true",
        "3, 2, 0, true",
        "0, 0, 0, false"
    })
    void aScanThatSpeaksAgainstThePlaceIsDue(int hits, int through, int shorter, boolean due) {
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        look(beams(8, 0, 0));
        for (int scan = 1; scan < 5; scan++) {
            isDue(Pose2d.ORIGIN, beams(8, 0, 0));
        }
        assertThat(isDue(Pose2d.ORIGIN, beams(hits, through, shorter))).isEqualTo(due);
    }

    /// From where it stands by odometry, a little farther on: 9 cm ahead the wall there is 9 cm nearer, and
    /// that behind farther away.
    @Test
    void whatIsComparedIsSeenFromWhereItIsNow() {
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        look(beams(8, 0, 0));
        Pose2d found = look(beams(40, 0, 0)).mapFromBase();
        assertThat(found.isNear(MIDDLE, 0.03, 0.03)).isTrue();
        var on = new Pose2d(0.09, 0, 0);
        for (int scan = 1; scan < 5; scan++) {
            isDue(on, Seen.straight(1));
        }
        Beams justThrough = Seen.straight(3.29f, 3.29f, 3.29f, 3.29f, 3.29f); // 2.9 m, and 4 deviations: from 3.21 m
        assertThat(isDue(on, justThrough)).isTrue();
        for (int scan = 1; scan < 5; scan++) {
            isDue(on, Seen.straight(1));
        }
        assertThat(isDue(on, Seen.straight(-3.29f, -3.29f, -3.29f, -3.29f, -3.29f)))
                .isFalse();
    }

    @Test
    void sonarsDoNotShowThatItWasCarried() {
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        look(beams(8, 0, 0));
        Beams laser = beams(0, 20, 0);
        var sonars = new Beams(laser.x(), laser.y(), laser.originX(), laser.originY(), 0.3);
        for (int scan = 1; scan <= 10; scan++) {
            assertThat(isDue(Pose2d.ORIGIN, sonars)).isFalse();
        }
        assertThat(asked).hasValue(2);
    }

    /// Nine tenths of the weights in one hypothesis, which says that it is localized.
    @ParameterizedTest
    @CsvSource({"0.92, 0.08, true", "0.88, 0.12, false", "1.84, 0.16, true", "0.46, 0.04, true", "0.08, 0.92, true"})
    void whoIsGivenOnePlaceIsSureOfItAtOnce(double one, double other, boolean sure) {
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        look(beams(8, 0, 0)); // what was before does not count
        amcl.start(belief(Quality.LOCALIZED, one, other));
        PoseEstimate reported = amcl.update(odometry, Seen.NOTHING);
        assertThat(reported.quality()).isEqualTo(sure ? Quality.LOCALIZED : Quality.AMBIGUOUS);
        assertThat(reported.confidence()).isCloseTo(sure ? TRUSTED * 0.97 : 0.5 * 0.5 * 0.97, within(1e-9));
        amcl.start(belief(Quality.AMBIGUOUS, one, other));
        assertThat(amcl.update(odometry, Seen.NOTHING).quality()).isEqualTo(Quality.AMBIGUOUS);
        amcl.start(belief(Quality.LOST, 1));
        assertThat(amcl.update(odometry, Seen.NOTHING).quality()).isEqualTo(Quality.AMBIGUOUS);
    }

    /// By wheels alone: the pose moves on, and what is not known grows as the model of odometry says. What is
    /// left of the confidence is 0.97 of it by each; half of that where it is not sure, from the fifth on; and
    /// a tenth where it is lost, from the thirtieth on.
    @Test
    void blindItReportsWhatTheWheelsSay() {
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        PoseEstimate before = look(beams(40, 0, 0));
        assertThat(before.quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(before.confidence()).isCloseTo(TRUSTED, within(1e-9));
        double confidence = before.confidence();
        for (int blind = 1; blind <= 35; blind++) {
            PoseEstimate reported = blindly();
            Pose2d on = before.mapFromBase().compose(STEP);
            assertThat(reported.mapFromBase().isNear(on, 1e-9, 1e-9))
                    .as("update %d", blind)
                    .isTrue();
            assertThat(reported.hypotheses()).hasSize(1);
            Covariance2d grown = before.covariance()
                    .plus(settings.odometry()
                            .covariance(STEP)
                            .turned(before.mapFromBase().theta()));
            assertThat(reported.covariance().xx()).isCloseTo(grown.xx(), within(1e-9));
            assertThat(reported.covariance().yy()).isCloseTo(grown.yy(), within(1e-9));
            assertThat(reported.covariance().xy()).isCloseTo(grown.xy(), within(1e-9));
            assertThat(reported.covariance().thetaTheta()).isCloseTo(grown.thetaTheta(), within(1e-9));
            boolean precise = reported.covariance().positionDeviation() <= 0.5;
            assertThat(reported.quality())
                    .as("update %d", blind)
                    .isEqualTo(
                            blind >= 30 ? Quality.LOST : blind < 5 && precise ? Quality.LOCALIZED : Quality.AMBIGUOUS);
            double share = blind >= 30 ? 0.1 : blind >= 5 ? 0.5 : 1;
            assertThat(reported.confidence()).isCloseTo(share * confidence * Math.pow(0.97, blind), within(1e-9));
            before = reported;
        }
        odometry = odometry.compose(STEP);
    }

    /// It is sure again after what it sees, as nothing spoke against it.
    @Test
    void aGlanceEndsItsBlindness() {
        amcl.start(PoseEstimate.of(MIDDLE, KNOWN));
        look(beams(40, 0, 0));
        for (int blind = 1; blind <= 6; blind++) {
            amcl.update(odometry, Seen.NOTHING);
        }
        assertThat(amcl.update(odometry, Seen.NOTHING).quality()).isEqualTo(Quality.AMBIGUOUS);
        PoseEstimate reported = look(beams(40, 0, 0));
        assertThat(reported.quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(reported.confidence()).isCloseTo(TRUSTED, within(1e-9));
    }

    /// Where it may be half a meter elsewhere it is not sure.
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.9})
    void whoKnowsItOnlyRoughlyIsNotSure(double deviation) {
        amcl.start(PoseEstimate.of(MIDDLE, Covariance2d.ofDeviations(deviation, deviation, 0.02)));
        PoseEstimate reported = amcl.update(odometry, Seen.NOTHING);
        assertThat(reported.quality()).isEqualTo(deviation < 0.5 ? Quality.LOCALIZED : Quality.AMBIGUOUS);
    }

    /// Of one scan whose beams go through walls, 3 of 10 that reach one must not: of those that end before a
    /// wall nobody asks, nor of a scan of which few reach any.
    @ParameterizedTest
    @CsvSource({
        "12, 28, 0, LOCALIZED",
        "11, 29, 0, LOST",
        "0, 40, 0, LOST",
        "12, 28, 10, LOCALIZED",
        "11, 29, 10, LOST",
        "0, 4, 0, LOCALIZED",
        "0, 4, 40, LOCALIZED",
        "0, 5, 0, LOST"
    })
    void aScanThatMostlyGoesThroughWallsIsThatOfALostRobot(int hits, int through, int shorter, Quality quality) {
        amcl.start(PoseEstimate.of(MIDDLE, Covariance2d.ofDeviations(0.001, 0.001, 0.001)));
        look(beams(40, 0, 0));
        assertThat(look(beams(hits, through, shorter)).quality()).isEqualTo(quality);
        assertThat(look(beams(40, 0, 0)).quality()).as("it was a moment").isEqualTo(Quality.LOCALIZED);
    }

    @Test
    void confidenceIsWhatScansSayOfThePose() {
        var monitor = new TrackingMonitor(15);
        monitor.trust();
        amcl.start(PoseEstimate.of(MIDDLE, Covariance2d.ofDeviations(0.001, 0.001, 0.001)));
        for (int[] fates : new int[][] {{40, 0, 0}, {30, 10, 0}, {32, 4, 4}, {20, 4, 16}}) {
            monitor.add(fates[0], fates[1], fates[2]);
            PoseEstimate reported = look(beams(fates[0], fates[1], fates[2]));
            assertThat(reported.quality()).isEqualTo(Quality.LOCALIZED);
            assertThat(reported.confidence()).isCloseTo(monitor.probability(), within(1e-9));
        }
    }

    /// More beams than usual go through walls, so that it looks elsewhere; but a square hall looks the same from four
    /// sides, and a robot whose odometry is unbroken is not at a twin that fits as well.
    @ParameterizedTest
    @CsvSource({"36, 4, 1", "36, 4, 2", "28, 12, 1", "30, 2, 8"})
    void aTwinIsNoReasonToDoubtThePoseThatIsFollowed(int hits, int through, int shorter) {
        amcl.start(PoseEstimate.of(MIDDLE, Covariance2d.ofDeviations(0.001, 0.001, 0.001)));
        for (int scan = 1; scan <= 40; scan++) {
            PoseEstimate reported = look(beams(hits, through, shorter));
            assertThat(reported.quality()).as("scan %d", scan).isEqualTo(Quality.LOCALIZED);
            assertThat(reported.mapFromBase().isNear(MIDDLE, 0.1, 0.1)).isTrue();
        }
    }

    /// Scan after scan of which two thirds go through walls.
    @Test
    void whatIsRefutedIsLostUntilScansSpeakForAPlace() {
        var monitor = new TrackingMonitor(15);
        monitor.trust();
        amcl.start(PoseEstimate.of(MIDDLE, Covariance2d.ofDeviations(0.001, 0.001, 0.001)));
        var qualities = new ArrayList<Quality>();
        boolean refuted = false;
        for (int scan = 0; scan < 20 && !refuted; scan++) {
            monitor.add(14, 26, 0);
            refuted = monitor.isRefuted();
            Quality quality = look(beams(14, 26, 0)).quality();
            qualities.add(quality);
            assertThat(quality == Quality.LOST).as("scan %d", scan).isEqualTo(refuted);
        }
        assertThat(qualities).contains(Quality.LOST);
        PoseEstimate reported = look(beams(14, 26, 0));
        assertThat(reported.confidence()).isLessThanOrEqualTo(0.1);
        for (int scan = 0; scan < 20 && reported.quality() == Quality.LOST; scan++) {
            reported = look(beams(40, 0, 0));
        }
        assertThat(reported.quality())
                .as("a square hall looks the same from four sides")
                .isEqualTo(Quality.AMBIGUOUS);
    }

    /// A square hall looks the same from four sides: a robot that is told nothing never knows.
    @Test
    void whoStartsAnywhereReportsAllPlacesThatLookTheSame() {
        amcl.startAnywhere();
        Pose2d truth = new Pose2d(2, 3.5, 0);
        var seen = new Seen(new DrawnMap(HALL.grid, Map.of()));
        PoseEstimate reported = look(seen.beams(truth, 40));
        for (int scan = 0; scan < 4; scan++) {
            reported = look(seen.beams(truth, 40));
            assertThat(reported.quality()).isNotEqualTo(Quality.LOCALIZED);
        }
        for (int quarter = 0; quarter < 4; quarter++) {
            Pose2d twin = MIDDLE.compose(new Pose2d(0, 0, quarter * Math.PI / 2))
                    .compose(MIDDLE.inverse().compose(truth));
            List<Hypothesis> near = reported.hypotheses().stream()
                    .filter(h -> h.mapFromBase().isNear(twin, 0.2, 0.2))
                    .toList();
            assertThat(near).as("quarter %d", quarter).hasSize(1);
            assertThat(near.getFirst().weight()).isBetween(0.15, 0.35);
        }
        assertThat(amcl.particleCount()).isEqualTo(amcl.particles().count());
    }

    @Test
    void itKeepsTheNumbersOfParticlesThatItIsGiven() {
        assertThat(settings.minParticles()).isEqualTo(100);
        assertThat(settings.maxParticles()).isEqualTo(500);
        assertThat(settings.model()).isEqualTo(SensorModel.Kind.FIELD);
        assertThat(settings.with(SensorModel.Kind.BEAM).model()).isEqualTo(SensorModel.Kind.BEAM);
        amcl.startAnywhere();
        look(beams(40, 0, 0));
        assertThat(amcl.particleCount()).isBetween(100, 500);
        amcl.start(PoseEstimate.of(MIDDLE, Covariance2d.ofDeviations(0, 0, 0)));
        look(beams(40, 0, 0));
        assertThat(amcl.particleCount()).isEqualTo(100);
    }
}
