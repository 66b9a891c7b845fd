package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

class AmclTest {
    private static final LocalizationMap ROOM = new LocalizationMap(Seen.ROOM.grid(), 0.1, 0.05);
    private static final Seen SEEN = new Seen(Seen.ROOM);
    private static final Pose2d STEP = new Pose2d(0.15, 0, 0.1);

    /// Half a turn makes it the same.
    private static final DrawnMap SYMMETRIC = Seen.fine("""
            ########################################
            #......................................#
            #..a...................................#
            #......................................#
            #...................................####
            ####...................................#
            #......................................#
            #......................................#
            #......................................#
            ########################################
            """);

    /// Rooms that differ by where a cupboard stands.
    private static final DrawnMap LIKE_ROOMS = Seen.fine("""
            ###################################################################
            #....................#......................#.................#####
            #....................#......................#.................#####
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #....................#......................#.....................#
            #..........a.........#...........b..........#..........c..........#
            #....................#......................#.....................#
            #####................#..................#####.....................#
            #####................#..................#####.....................#
            #########...##################...####################...###########
            #.................................................................#
            #.................................................................#
            #.................................................................#
            #.................................................................#
            ###################################################################
            """);

    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 2)
    void findsItselfWithoutAGivenPose(long seed) {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(seed));
        Pose2d truth = Seen.ROOM.pose('a', -40.0 * seed);

        List<PoseEstimate> reported = drive(amcl, SEEN, truth, Pose2d.ORIGIN, 8);

        assertThat(reported.getLast().quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(reported.getLast().mapFromBase().distanceTo(after(truth, 8))).isLessThan(0.06);
    }

    /// It goes any way while it turns, and its wheels count a twentieth too much and drift aside.
    @Trials({"1", "2", "3"})
    void followsABaseThatGoesSideways(long seed) {
        var odometry = new OdometryModel(0.1, 0.06, 0.12, 0.1, OdometryModel.Base.OMNIDIRECTIONAL);
        var settings = new Amcl.Settings(150, 3000, 15, 0.1, Math.toRadians(6), odometry, new Kld(0.05, 2.33));
        var amcl = new Amcl(ROOM, settings, new SplittableRandom(seed));
        Pose2d truth = Seen.ROOM.pose('a', 0);
        amcl.start(PoseEstimate.of(truth, Covariance2d.ofDeviations(0.1, 0.1, 0.05)));
        Pose2d odomFromBase = Pose2d.ORIGIN;
        PoseEstimate estimate = amcl.update(odomFromBase, SEEN.beams(truth, 60));
        for (int i = 1; i <= 24; i++) {
            double distance = -2 * Math.PI * i / 24; // around a circle of 0.6 m, which it never faces
            truth = truth.compose(
                    new Pose2d(0.15 * Math.cos(distance - 0.05 * i), 0.15 * Math.sin(distance - 0.05 * i), 0.05));
            odomFromBase = odomFromBase.compose(new Pose2d(
                    0.1575 * Math.cos(distance - 0.05 * i), 0.1575 * Math.sin(distance - 0.05 * i) + 0.004, 0.052));
            assertThat(SEEN.isFree(truth)).isTrue();
            estimate = amcl.update(odomFromBase, SEEN.beams(truth, 60));
            assertThat(estimate.mapFromBase().distanceTo(truth)).isLessThan(0.1);
        }
        assertThat(estimate.quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(estimate.mapFromBase().distanceTo(truth)).isLessThan(0.06);
    }

    /// Nobody tells it where it is, and after 100 updates somebody carries it to the other side of a wall.
    @LongTest
    @Trials(
            value = {"16, 1", "8, 1", "16, 2", "16, 3", "8, 2", "8, 3"},
            landing = 2)
    void findsItselfBySonarsAloneAndAgainAfterItWasCarried(int sonars, long seed) {
        Amcl.Settings settings = Amcl.Settings.of(150, 3000).with(SensorModel.Kind.BEAM);
        var amcl = new Amcl(ROOM, settings, new SplittableRandom(seed));
        Pose2d truth = Seen.ROOM.pose('a', 0);
        Pose2d odomFromBase = Pose2d.ORIGIN;
        PoseEstimate estimate = amcl.update(odomFromBase, SEEN.sonars(truth, sonars));
        int sure = 0;
        for (int i = 1; i < 100; i++) {
            truth = truth.compose(new Pose2d(0.12, 0, -0.14)); // around a circle of 0.86 m
            odomFromBase = odomFromBase.compose(new Pose2d(0.126, 0, -0.137));
            estimate = amcl.update(odomFromBase, SEEN.sonars(truth, sonars));
            if (estimate.quality() == Quality.LOCALIZED) {
                sure++;
                assertThat(estimate.mapFromBase().distanceTo(truth))
                        .as("update %d", i)
                        .isLessThan(0.3);
            }
        }
        assertThat(sure).isGreaterThan(40);

        truth = Seen.ROOM.pose('k', 90);
        int wrong = 0;
        for (int i = 0; i < 50; i++) {
            estimate = amcl.update(odomFromBase, SEEN.sonars(truth, sonars));
            boolean off = estimate.mapFromBase().distanceTo(truth) > 0.3;
            wrong += off && estimate.quality() == Quality.LOCALIZED ? 1 : 0;
            truth = truth.compose(new Pose2d(0.06, 0, -0.14));
            assertThat(SEEN.isFree(truth)).isTrue();
            odomFromBase = odomFromBase.compose(new Pose2d(0.063, 0, -0.137));
        }
        assertThat(wrong).isLessThan(6);
        assertThat(estimate.quality()).isNotEqualTo(Quality.LOST);
        Pose2d back = truth.compose(new Pose2d(0.06, 0, -0.14).inverse());
        assertThat(estimate.mapFromBase().distanceTo(back)).isLessThan(0.3);
    }

    @Trials({"1", "2", "3"})
    void noticesThatItIsCarriedWhileItsWheelsStand(long seed) {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(seed));
        Pose2d first = Seen.ROOM.pose('a', 0);
        amcl.start(PoseEstimate.of(first, Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        PoseEstimate estimate = drive(amcl, SEEN, first, Pose2d.ORIGIN, 5).getLast();
        assertThat(estimate.quality()).isEqualTo(Quality.LOCALIZED);
        Pose2d standing = after(Pose2d.ORIGIN, 5);
        for (int scan = 0; scan < 50; scan++) {
            Beams beams = SEEN.beams(after(first, 5), 60);
            assertThat(amcl.due(standing, () -> beams)).as("nothing new").isFalse();
        }

        int looks = 0;
        Beams elsewhere = SEEN.beams(Seen.ROOM.pose('k', 100), 60);
        for (int scan = 0; scan < 100; scan++) {
            if (amcl.due(standing, () -> elsewhere)) {
                estimate = amcl.update(standing, elsewhere);
                looks++;
            }
        }
        assertThat(looks).isBetween(3, 20);
        assertThat(estimate.quality()).isNotEqualTo(Quality.LOCALIZED);
    }

    @Test
    void isLostUntilItHasSeenSomething() {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(1));

        PoseEstimate estimate = amcl.update(Pose2d.ORIGIN, Seen.NOTHING);

        assertThat(estimate.quality()).isEqualTo(Quality.LOST);
        assertThat(estimate.confidence()).isBetween(0.0, 1.0);
    }

    @Test
    void isEverLessSureWhileItSeesNothing() {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(1));
        Pose2d first = Seen.ROOM.pose('a', 0);
        amcl.start(PoseEstimate.of(first, Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        PoseEstimate before = drive(amcl, SEEN, first, Pose2d.ORIGIN, 5).getLast();
        assertThat(before.quality()).isEqualTo(Quality.LOCALIZED);

        for (int i = 6; i < 40; i++) {
            PoseEstimate now = amcl.update(after(Pose2d.ORIGIN, i), Seen.NOTHING);
            assertThat(now.confidence()).as("confidence %d", i).isLessThan(before.confidence());
            assertThat(now.covariance().positionDeviation())
                    .as("deviation %d", i)
                    .isGreaterThan(before.covariance().positionDeviation());
            before = now;
        }
        assertThat(before.quality()).isEqualTo(Quality.LOST);
    }

    @Test
    void doesNotKnowThatItIsAtTheGivenPoseWhenItSeesNothing() {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(1));
        amcl.start(PoseEstimate.of(Seen.ROOM.pose('a', 0), Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        PoseEstimate reported = amcl.update(Pose2d.ORIGIN, Seen.NOTHING);
        for (int i = 1; i < 40; i++) {
            reported = amcl.update(after(Pose2d.ORIGIN, i), Seen.NOTHING);
        }
        assertThat(reported.quality()).isEqualTo(Quality.LOST);
        assertThat(reported.confidence()).isLessThan(0.4);
    }

    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 2)
    void noticesThatItWasCarriedAwayAndFindsBack(long seed) {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(seed));
        Pose2d first = Seen.ROOM.pose('a', 0);
        amcl.start(PoseEstimate.of(first, Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        drive(amcl, SEEN, first, Pose2d.ORIGIN, 5);
        Pose2d elsewhere = Seen.ROOM.pose('k', 180);

        List<PoseEstimate> reported = drive(amcl, SEEN, elsewhere, after(Pose2d.ORIGIN, 5), 20);

        assertThat(reported).anyMatch(estimate -> estimate.quality() == Quality.LOST);
        assertThat(reported.getLast().quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(reported.getLast().mapFromBase().distanceTo(after(elsewhere, 20)))
                .isLessThan(0.1);
    }

    /// Nine of ten beams fit in the room next door too: as in a room where a cupboard was moved. It can't know which of
    /// both is so, and says it.
    @Trials(
            value = {"1, b", "2, c", "3, b", "4, c"},
            landing = 2)
    void noticesThatItMayHaveBeenCarriedToARoomThatIsAlike(long seed, char room) {
        var seen = new Seen(LIKE_ROOMS);
        var amcl = new Amcl(
                new LocalizationMap(LIKE_ROOMS.grid(), 0.1, 0.05),
                Amcl.Settings.of(150, 3000),
                new SplittableRandom(seed));
        Pose2d first = LIKE_ROOMS.pose('a', 0);
        amcl.start(PoseEstimate.of(first, Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        assertThat(drive(amcl, seen, first, Pose2d.ORIGIN, 40))
                .allMatch(estimate -> estimate.quality() == Quality.LOCALIZED);
        Pose2d elsewhere = after(LIKE_ROOMS.pose(room, 0), 40);

        List<PoseEstimate> reported = drive(amcl, seen, elsewhere, after(Pose2d.ORIGIN, 40), 60);

        assertThat(reported.getLast().quality()).isEqualTo(Quality.AMBIGUOUS);
        assertThat(reported.getLast().hypotheses())
                .anyMatch(h -> h.mapFromBase().distanceTo(after(elsewhere, 60)) < 0.1);
    }

    @LongTest
    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 2)
    void onTheMapOfAnotherBuildingItIsNowhere(long seed) {
        var seen = new Seen(LIKE_ROOMS);
        Pose2d truth = LIKE_ROOMS.pose("abc".charAt((int) seed % 3), 0);
        for (DrawnMap other : List.of(SYMMETRIC, Seen.ROOM)) {
            var amcl = new Amcl(
                    new LocalizationMap(other.grid(), 0.1, 0.05),
                    Amcl.Settings.of(150, 3000),
                    new SplittableRandom(seed));
            assertThat(drive(amcl, seen, truth, Pose2d.ORIGIN, 60))
                    .noneMatch(estimate -> estimate.quality() == Quality.LOCALIZED);
        }
    }

    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 2)
    void somebodyWhoWalksAlongIsNoReasonToDoubt(long seed) {
        var amcl = new Amcl(
                new LocalizationMap(LIKE_ROOMS.grid(), 0.1, 0.05),
                Amcl.Settings.of(150, 3000),
                new SplittableRandom(seed));
        var seen = new Seen(LIKE_ROOMS);
        Pose2d first = LIKE_ROOMS.pose('a', 0);
        amcl.start(PoseEstimate.of(first, Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        for (int i = 0; i < 60; i++) {
            PoseEstimate reported = amcl.update(after(Pose2d.ORIGIN, i), covered(seen.beams(after(first, i), 60), 20));
            holdsTogether(reported);
            assertThat(reported.quality()).as("update %d", i).isEqualTo(Quality.LOCALIZED);
        }
        assertThat(amcl.update(after(Pose2d.ORIGIN, 60), seen.beams(after(first, 60), 60))
                        .mapFromBase()
                        .distanceTo(after(first, 60)))
                .isLessThan(0.1);
    }

    /// So many of the beams end within half a meter.
    private static Beams covered(Beams beams, int count) {
        for (int i = 0; i < count; i++) {
            double length = Math.hypot(beams.x()[i], beams.y()[i]);
            beams.x()[i] *= (float) Math.min(1, 0.5 / length);
            beams.y()[i] *= (float) Math.min(1, 0.5 / length);
        }
        return beams;
    }

    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 2)
    void saysThatASymmetricPlaceIsAmbiguous(long seed) {
        var map = new LocalizationMap(SYMMETRIC.grid(), 0.1, 0.05);
        var amcl = new Amcl(map, Amcl.Settings.of(150, 3000), new SplittableRandom(seed));
        Pose2d there = new Pose2d(0.15, 0, 0);
        var seen = new Seen(SYMMETRIC);
        Pose2d truth = SYMMETRIC.pose('a', 0);
        Pose2d odometry = Pose2d.ORIGIN;
        var reported = new ArrayList<PoseEstimate>();
        for (int i = 0; i < 30; i++) {
            reported.add(amcl.update(odometry, seen.beams(truth, 60)));
            truth = truth.compose(there);
            odometry = odometry.compose(there);
        }

        assertThat(reported).noneMatch(estimate -> estimate.quality() == Quality.LOCALIZED);
        assertThat(reported).allSatisfy(AmclTest::holdsTogether);
        Pose2d last = truth.compose(there.inverse());
        Pose2d mirrored = mirrored(last);
        assertThat(reported.getLast().hypotheses())
                .anyMatch(h -> h.weight() > 0.1 && h.mapFromBase().isNear(last, 0.2, 0.2))
                .anyMatch(h -> h.weight() > 0.1 && h.mapFromBase().isNear(mirrored, 0.2, 0.2));
    }

    private static Pose2d mirrored(Pose2d pose) {
        return new Pose2d(10 - pose.x(), 2.5 - pose.y(), pose.theta() + Math.PI);
    }

    /// Of two places that look the same, particles sooner or later leave one by chance.
    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 2)
    void aBeliefInTwoPlacesStaysAmbiguousWhereTheyLookTheSame(long seed) {
        var amcl = new Amcl(
                new LocalizationMap(SYMMETRIC.grid(), 0.1, 0.05),
                Amcl.Settings.of(150, 3000),
                new SplittableRandom(seed));
        var seen = new Seen(SYMMETRIC);
        Pose2d there = new Pose2d(0.15, 0, 0);
        Pose2d truth = SYMMETRIC.pose('a', 0);
        Covariance2d known = Covariance2d.ofDeviations(0.1, 0.1, 0.05);
        amcl.start(new PoseEstimate(
                truth,
                known,
                List.of(new Hypothesis(0.6, truth, known), new Hypothesis(0.4, mirrored(truth), known)),
                0.6,
                Quality.AMBIGUOUS));
        Pose2d odometry = Pose2d.ORIGIN;
        for (int i = 0; i < 40; i++) {
            assertThat(amcl.update(odometry, seen.beams(truth, 60)).quality())
                    .as("update %d", i)
                    .isEqualTo(Quality.AMBIGUOUS);
            truth = truth.compose(there);
            odometry = odometry.compose(there);
        }
    }

    @Test
    void aBeliefInTwoPlacesIsSettledWhereTheyLookDifferent() {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(1));
        Pose2d truth = Seen.ROOM.pose('b', 90);
        Covariance2d known = Covariance2d.ofDeviations(0.1, 0.1, 0.05);
        amcl.start(new PoseEstimate(
                Seen.ROOM.pose('a', 0),
                known,
                List.of(new Hypothesis(0.6, Seen.ROOM.pose('a', 0), known), new Hypothesis(0.4, truth, known)),
                0.6,
                Quality.AMBIGUOUS));
        List<PoseEstimate> reported = drive(amcl, SEEN, truth, Pose2d.ORIGIN, 8);
        assertThat(reported.getLast().quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(reported.getLast().mapFromBase().distanceTo(after(truth, 8))).isLessThan(0.06);
    }

    private static void holdsTogether(PoseEstimate reported) {
        List<Hypothesis> hypotheses = reported.hypotheses();
        assertThat(hypotheses.getFirst().mapFromBase()).isEqualTo(reported.mapFromBase());
        assertThat(hypotheses)
                .isSortedAccordingTo(
                        Comparator.comparingDouble(Hypothesis::weight).reversed());
        assertThat(hypotheses.stream().mapToDouble(Hypothesis::weight).sum()).isBetween(0.0, 1 + 1e-9);
        switch (reported.quality()) {
            case LOCALIZED -> assertThat(reported.confidence()).isBetween(0.75, 1.0);
            case AMBIGUOUS -> assertThat(reported.confidence()).isBetween(0.0, 0.5);
            case LOST -> assertThat(reported.confidence()).isBetween(0.0, 0.1);
        }
        for (Hypothesis one : hypotheses) {
            assertThat(hypotheses.stream().filter(h -> h.mapFromBase().isNear(one.mapFromBase(), 0.1, 0.1)))
                    .as("two of the same place")
                    .hasSize(1);
        }
    }

    @ParameterizedTest
    @EnumSource(SensorModel.Kind.class)
    void aMapThatEndsInTheMiddleOfAHallIsNoReasonToBeLost(SensorModel.Kind model) {
        DrawnMap hall = Seen.fine("""
                ################################################
                #...##....##...................................#
                #..............................................#
                #..............................................#
                #..............................................#
                #..............................................#
                #....###.......................................#
                #....###.......................................#
                #..............................................#
                #..................b...........................#
                #..............................................#
                #..............................................#
                #..............................................#
                #..............................................#
                #..............................................#
                #..............................................#
                #......##....##................................#
                ################################################
                """);
        OccupancyGrid known = leftOf(hall.grid(), 100); // 5 m of 12 m
        var amcl = new Amcl(
                new LocalizationMap(known, 0.1, 0.05),
                Amcl.Settings.of(150, 3000).with(model),
                new SplittableRandom(1));
        Pose2d truth = hall.pose('b', 0);
        amcl.start(PoseEstimate.of(truth, Covariance2d.ofDeviations(0.1, 0.1, 0.05)));
        var seen = new Seen(hall);
        var turn = new Pose2d(0, 0, 0.15);
        Pose2d odometry = Pose2d.ORIGIN;
        for (int i = 0; i < 60; i++) {
            PoseEstimate reported = amcl.update(odometry, seen.beams(truth, 60));
            assertThat(reported.quality()).as("update %d", i).isEqualTo(Quality.LOCALIZED);
            assertThat(reported.confidence()).isGreaterThan(0.9);
            assertThat(reported.mapFromBase().distanceTo(truth)).isLessThan(0.1);
            truth = truth.compose(turn);
            odometry = odometry.compose(turn);
        }
    }

    /// Beams that end on the walls beyond would be likelier farther inside.
    @ParameterizedTest
    @CsvSource({"FIELD, 1", "FIELD, 2", "FIELD, 3", "BEAM, 1", "BEAM, 2", "BEAM, 3"})
    void whereTheMapOfACorridorEndsItIsNotPulledInward(SensorModel.Kind model, long seed) {
        DrawnMap corridor = Seen.fine("""
                ################################################
                #..............................................#
                #..................b...........................#
                #..............................................#
                #####.##################.#######################
                #...........#..................................#
                #...........#..................................#
                ################################################
                """);
        var amcl = new Amcl(
                new LocalizationMap(leftOf(corridor.grid(), 100), 0.1, 0.05),
                Amcl.Settings.of(150, 3000).with(model),
                new SplittableRandom(seed));
        Pose2d truth = corridor.pose('b', 0);
        amcl.start(PoseEstimate.of(truth, Covariance2d.ofDeviations(0.1, 0.1, 0.05)));
        var seen = new Seen(corridor);
        var turn = new Pose2d(0, 0, 0.15);
        Pose2d odometry = Pose2d.ORIGIN;
        for (int i = 0; i < 60; i++) {
            PoseEstimate reported = amcl.update(odometry, seen.beams(truth, 60));
            assertThat(reported.mapFromBase().distanceTo(truth))
                    .as("update %d", i)
                    .isLessThan(0.1);
            truth = truth.compose(turn);
            odometry = odometry.compose(turn);
        }
    }

    private static OccupancyGrid leftOf(OccupancyGrid whole, int columns) {
        var cells = new byte[columns * whole.height()];
        for (int i = 0; i < cells.length; i++) {
            cells[i] = whole.at(i % columns, i / columns);
        }
        return new OccupancyGrid(columns, whole.height(), whole.resolution(), 0, 0, cells);
    }

    @Test
    void aPoseThatIsGivenEndsTheAmbiguity() {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(1));
        drive(amcl, SEEN, Seen.ROOM.pose('a', 0), Pose2d.ORIGIN, 3);

        amcl.start(PoseEstimate.of(Seen.ROOM.pose('b', 90), Covariance2d.ofDeviations(0.2, 0.2, 0.1)));
        List<PoseEstimate> reported = drive(amcl, SEEN, Seen.ROOM.pose('b', 90), Pose2d.ORIGIN, 2);

        assertThat(reported.getFirst().quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(reported.getFirst().mapFromBase().distanceTo(Seen.ROOM.pose('b', 90)))
                .isLessThan(0.06);
    }

    @Test
    void refusesWhatIsNoNumberAndStaysAsItWas() {
        var amcl = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(1));
        Pose2d truth = Seen.ROOM.pose('b', 90);
        Covariance2d known = Covariance2d.ofDeviations(0.2, 0.2, 0.1);
        var unknown = new Covariance2d(0.04, Double.NaN, 0, 0.04, 0, 0.01);
        var nowhere = new Pose2d(1, Double.NaN, 0);
        amcl.start(PoseEstimate.of(truth, known));
        drive(amcl, SEEN, truth, Pose2d.ORIGIN, 1);

        for (PoseEstimate belief : List.of(
                PoseEstimate.of(nowhere, known),
                PoseEstimate.of(truth, unknown),
                among(new Hypothesis(1, nowhere, known)),
                among(new Hypothesis(1, truth, unknown)),
                among(new Hypothesis(Double.NaN, truth, known)))) {
            assertThatIllegalArgumentException().isThrownBy(() -> amcl.start(belief));
        }
        assertThatIllegalArgumentException().isThrownBy(() -> amcl.update(nowhere, SEEN.beams(truth, 60)));

        PoseEstimate then = amcl.update(after(Pose2d.ORIGIN, 2), SEEN.beams(after(truth, 2), 60));
        assertThat(then.quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(then.mapFromBase().distanceTo(after(truth, 2))).isLessThan(0.06);
    }

    /// A belief whose best pose is known.
    private static PoseEstimate among(Hypothesis hypothesis) {
        return new PoseEstimate(
                Seen.ROOM.pose('b', 90),
                Covariance2d.ofDeviations(0.2, 0.2, 0.1),
                List.of(hypothesis),
                1,
                Quality.AMBIGUOUS);
    }

    @Test
    void doesTheSameForTheSameSeed() {
        Pose2d truth = Seen.ROOM.pose('a', 10);
        var one = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(3));
        var other = new Amcl(ROOM, Amcl.Settings.of(150, 3000), new SplittableRandom(3));

        assertThat(drive(one, SEEN, truth, Pose2d.ORIGIN, 6)).isEqualTo(drive(other, SEEN, truth, Pose2d.ORIGIN, 6));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.25, 0.5})
    void isRightOnMapsOfLargeCells(double resolution) {
        DrawnMap hall = DrawnMap.grid(resolution, """
                ##########################
                #........................#
                #..a.....................#
                #........................#
                #.......####.............#
                #.......####.............#
                #........................#
                #........................#
                #........................#
                #...............###......#
                #...............###......#
                #........................#
                #........................#
                ##########################
                """);
        var amcl = new Amcl(
                new LocalizationMap(hall.grid(), 0.1, 0.05), Amcl.Settings.of(150, 3000), new SplittableRandom(1));
        Pose2d truth = hall.pose('a', -60);
        amcl.start(PoseEstimate.of(truth, Covariance2d.ofDeviations(0.2, 0.2, 0.1)));

        List<PoseEstimate> reported = drive(amcl, new Seen(hall), truth, Pose2d.ORIGIN, 8);

        for (int i = 3; i < reported.size(); i++) {
            assertThat(reported.get(i).mapFromBase().distanceTo(after(truth, i)))
                    .as("after %d steps", i)
                    .isLessThan(0.06);
        }
    }

    @Test
    void aMapWithoutWallsOrFreeCellsSaysNothing() {
        for (String drawing : List.of("...\n...\n", "???\n")) {
            var map = new LocalizationMap(DrawnMap.grid(0.5, drawing).grid(), 0.1, 0.05);
            var amcl = new Amcl(map, Amcl.Settings.of(50, 200), new SplittableRandom(1));

            List<PoseEstimate> reported = drive(amcl, SEEN, Seen.ROOM.pose('a', 0), Pose2d.ORIGIN, 3);

            assertThat(reported).allMatch(estimate -> estimate.mapFromBase().isFinite());
            assertThat(reported).noneMatch(estimate -> estimate.quality() == Quality.LOCALIZED);
        }
    }

    private static List<PoseEstimate> drive(Amcl amcl, Seen seen, Pose2d from, Pose2d odomFrom, int steps) {
        var reported = new ArrayList<PoseEstimate>();
        for (int i = 0; i <= steps; i++) {
            Pose2d truth = after(from, i);
            assertThat(seen.isFree(truth))
                    .as("no robot drives through walls: %s", truth)
                    .isTrue();
            reported.add(amcl.update(after(odomFrom, i), seen.beams(truth, 60)));
        }
        assertThat(reported).allSatisfy(AmclTest::holdsTogether);
        return reported;
    }

    private static Pose2d after(Pose2d start, int steps) {
        Pose2d pose = start;
        for (int i = 0; i < steps; i++) {
            pose = pose.compose(STEP);
        }
        return pose;
    }
}
