package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate.Quality;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.scanmatch.Walls;
import rsal.testkit.LongTest;

class SlamTest {
    /// Corridors around a block with niches, 26 m × 18 m.
    private static final Walls FLOOR = new Walls()
            .box(0, 0, 26, 18)
            .chain(2.5, 2.5, 9, 2.5, 9, 3.5, 10, 3.5, 10, 2.5, 23.5, 2.5, 23.5, 8, 22, 8, 22, 9, 23.5, 9, 23.5, 15.5)
            .chain(
                    23.5, 15.5, 14, 15.5, 14, 14, 12, 14, 12, 15.5, 2.5, 15.5, 2.5, 11, 3.5, 11, 3.5, 10, 2.5, 10, 2.5,
                    2.5)
            .box(17, 0, 17.4, 0.4)
            .box(0, 6, 0.5, 6.5)
            .box(25, 12, 26, 12.6);

    private record Drive(List<Pose2d> truth, List<Pose2d> odometry) {}

    /// Around it and a bit more, counter-clockwise, with wheels that err.
    private static Drive drive(SplittableRandom random) {
        var truth = new ArrayList<Pose2d>();
        var odometry = new ArrayList<Pose2d>();
        truth.add(new Pose2d(1.2, 1.2, 0));
        odometry.add(truth.getFirst());
        double[] sides = {23.4, 15.4, 23.4, 15.4, 10};
        for (double side : sides) {
            int steps = (int) (side / 0.6);
            for (int i = 1; i <= steps; i++) {
                move(truth, odometry, new Pose2d(side / steps, 0, 0), random);
            }
            for (int i = 0; i < 3; i++) {
                move(truth, odometry, new Pose2d(0, 0, Math.PI / 6), random);
            }
        }
        return new Drive(truth, odometry);
    }

    private static void move(List<Pose2d> truth, List<Pose2d> odometry, Pose2d way, SplittableRandom random) {
        truth.add(truth.getLast().compose(way));
        double turn = 0.05 * Math.abs(way.theta()) + 0.03 * way.x();
        odometry.add(odometry.getLast()
                .compose(new Pose2d(
                        way.x() * (1 + 0.05 * random.nextGaussian()),
                        0,
                        way.theta() + turn * random.nextGaussian() + 0.01 * way.x())));
    }

    private static double worst(List<Pose2d> truth, List<Pose2d> poses) {
        double worst = 0;
        for (int i = 0; i < truth.size(); i++) {
            worst = Math.max(worst, truth.get(i).distanceTo(poses.get(i)));
        }
        return worst;
    }

    private record Run(Slam slam, List<Slam.Located> located) {
        List<Pose2d> poses() {
            return located.stream().map(slam::pose).toList();
        }
    }

    private static Run run(Slam.Settings settings, Drive drive, SplittableRandom random) {
        var slam = new Slam(settings);
        var located = new ArrayList<Slam.Located>();
        for (int i = 0; i < drive.truth().size(); i++) {
            located.add(
                    slam.add(drive.odometry().get(i), FLOOR.scan(drive.truth().get(i), 0.01, random)));
        }
        return new Run(slam, located);
    }

    @Test
    void closesALoopAndMapsTheFloor() {
        var random = new SplittableRandom(11);
        Drive drive = drive(random);
        Run run = run(Slam.Settings.DEFAULT, drive, random);
        run.slam().polish(2);

        assertThat(worst(drive.truth(), drive.odometry())).isGreaterThan(3);
        assertThat(worst(drive.truth(), run.poses())).isLessThan(0.3);
        assertThat(run.slam().relations()).anyMatch(r -> r.source() == Relation.Source.LOOP);
        OccupancyGrid map = run.slam().map(ScanMapper.Settings.of(0.1));
        assertThat(map.isFree(1.2, 1.2)).isTrue();
        assertThat(map.isFree(24.8, 16.5)).isTrue();
        assertThat(map.isFree(13, 9)).isFalse();
        assertThat(map.width() * map.resolution()).isBetween(26.0, 28.0);
    }

    @LongTest
    @Test
    void givesAWrongLoopUpWhenOthersContradictIt() {
        var random = new SplittableRandom(11);
        Drive drive = drive(random);
        var slam = new Slam(Slam.Settings.DEFAULT);
        var kept = new ArrayList<Pose2d>(); // where frames were taken
        int wrong = -1; // the frame that told it
        boolean back = false;
        double worst = 0;
        for (int i = 0; i < drive.truth().size(); i++) {
            Pose2d truth = drive.truth().get(i);
            Slam.Located located = slam.add(drive.odometry().get(i), FLOOR.scan(truth, 0.01, random));
            if (slam.frameCount() > kept.size()) {
                kept.add(truth);
            }
            double distance = truth.distanceTo(kept.getFirst());
            if (wrong < 0 && i > 60 && distance < 9) { // the wrong one is the first that knows this end of the way
                Pose2d is = kept.getFirst().inverse().compose(kept.getLast());
                var reported = new Pose2d(is.x() + 0.4, is.y() + 0.3, is.theta());
                var sure = Covariance2d.ofDeviations(0.05, 0.05, 0.01);
                slam.close(List.of(new Relation(0, kept.size() - 1, reported, sure, Relation.Source.LOOP)));
                assertThat(slam.pose(located).distanceTo(truth)).isGreaterThan(0.4);
                wrong = kept.size() - 1;
            } else if (wrong >= 0) {
                back |= Math.abs(truth.theta()) < 0.01; // where it drove first, again
                worst = back ? Math.max(worst, slam.pose(located).distanceTo(truth)) : 0;
            }
        }

        assertThat(back).isTrue();
        assertThat(worst).isLessThan(0.05);
        int dropped = wrong;
        assertThat(slam.relations()).noneMatch(r -> r.from() == 0 && r.to() == dropped);
    }

    @Test
    void knowsALaserThatIsMountedUpsideDownByItsTurns() {
        var random = new SplittableRandom(11);
        var upright = new Slam(Slam.Settings.DEFAULT);
        var mirrored = new Slam(Slam.Settings.DEFAULT);
        var pose = new Pose2d(1.2, 1.2, 0);
        for (int i = 0; i < 120; i++) {
            pose = pose.compose(new Pose2d(0.1, 0, i % 40 < 20 ? 0.12 : -0.12));
            LaserScan scan = FLOOR.scan(pose, 0.01, random);
            var ranges = new float[scan.count()];
            for (int beam = 0; beam < ranges.length; beam++) {
                ranges[beam] = scan.ranges()[ranges.length - 1 - beam];
            }
            upright.add(pose, scan);
            mirrored.add(
                    pose,
                    new LaserScan(
                            scan.baseFromLaser(),
                            scan.angleMin(),
                            scan.angleIncrement(),
                            scan.rangeMin(),
                            scan.rangeMax(),
                            ranges));
        }

        assertThat(mirrored.turns().isReversed()).isTrue();
        assertThat(upright.turns().isReversed()).isFalse();
        assertThat(upright.turns().opposed()).isZero();
        assertThat(upright.turns().count()).isGreaterThan(8);
        assertThat(upright.contradiction())
                .hasValueSatisfying(most -> assertThat(most.share()).isLessThan(0.1));
    }

    @Test
    void theSameScansGiveTheSameMap() {
        Drive drive = drive(new SplittableRandom(3));

        assertThat(run(Slam.Settings.DEFAULT, drive, new SplittableRandom(1)).poses())
                .isEqualTo(run(Slam.Settings.DEFAULT, drive, new SplittableRandom(1))
                        .poses());
    }

    @Test
    void goesOnFindingItsWayWhenItMayKeepNoMore() {
        Drive drive = drive(new SplittableRandom(3));
        var settings = new Slam.Settings(25, 0.5, 0.35, Slam.Wheels.ROUGH, 10, true, 5);

        Run run = run(settings, drive, new SplittableRandom(1));

        assertThat(run.slam().frameCount()).isEqualTo(5);
        assertThat(run.located()).hasSize(drive.truth().size());
        assertThat(run.poses().get(8).isNear(drive.truth().get(8), 0.3, 0.1)).isTrue();
    }

    @LongTest
    @Test
    void findsItsWayInAllOfItsMapWhenItMayKeepNoMore() {
        Drive drive = drive(new SplittableRandom(3));
        int around = 2 * (39 + 25 + 6); // steps
        Slam once = run(Slam.Settings.DEFAULT, part(drive, 0, around, Pose2d.ORIGIN), new SplittableRandom(1))
                .slam();
        var settings = new Slam.Settings(25, 0.5, 0.35, Slam.Wheels.ROUGH, 10, true, once.frameCount());

        Run run = run(settings, drive, new SplittableRandom(1));

        assertThat(run.slam().frameCount()).isEqualTo(once.frameCount());
        assertThat(drive.truth().getLast().distanceTo(drive.truth().get(around)))
                .isGreaterThan(8);
        assertThat(run.poses().getLast().isNear(drive.truth().getLast(), 0.5, 0.05))
                .isTrue();
        assertThat(run.slam().tracking().quality()).isEqualTo(Quality.LOCALIZED);
    }

    @LongTest
    @Test
    void findsATurnAgainThatTheWheelsMistakeByFar() {
        var random = new SplittableRandom(5);
        Drive drive = part(drive(random), 0, 55, Pose2d.ORIGIN);
        Pose2d before = drive.odometry().get(40); // in the middle of a turn
        Pose2d shift = before.compose(new Pose2d(0, 0, Math.toRadians(17))).compose(before.inverse());
        var odometry = new ArrayList<Pose2d>(drive.odometry().subList(0, 41));
        odometry.addAll(part(drive, 41, 55, shift).odometry());

        List<Pose2d> poses = run(Slam.Settings.DEFAULT, new Drive(drive.truth(), odometry), random)
                .poses();

        Pose2d turned = poses.get(40).inverse().compose(poses.get(41));
        Pose2d right = drive.truth().get(40).inverse().compose(drive.truth().get(41));
        assertThat(turned.isNear(right, 0.05, 0.02)).isTrue();
        assertThat(worst(drive.truth(), poses)).isLessThan(0.3);
    }

    @Test
    void behindADoorItBelievesALittleThatFitsInOnePlaceOnly() {
        Walls rooms = behindADoor()
                .chain(6.2, 3.2, 6.2, 7, 12, 7, 12, 4, 11, 4, 11, 1, 12, 1, 12, -2, 6.2, -2, 6.2, 1.8)
                .box(8.5, 3.2, 9, 3.6)
                .box(8, -0.5, 8.6, 0.4);

        assertThat(through(rooms, 4.25, 1.75, 12).seeing()).isTrue();
    }

    @Test
    void butNotThatWhichFitsInSeveral() {
        Walls pillars = behindADoor().chain(6.2, 3.2, 6.2, 30).chain(6.2, -30, 6.2, 1.8);
        for (double y = -3; y < 8; y += 0.5) {
            pillars.box(8, y, 8.2, y + 0.2);
        }

        assertThat(through(pillars, 4, 2.25, 8).seeing()).isFalse();
    }

    /// A room with a door of 1.4 m in a wall of 0.2 m.
    private static Walls behindADoor() {
        return new Walls()
                .chain(6, 1.8, 6, 0, 0, 0, 0, 5, 6, 5, 6, 3.2)
                .chain(6, 1.8, 6.2, 1.8)
                .chain(6, 3.2, 6.2, 3.2);
    }

    /// Goes some way in one step, from somewhere before the door, with wheels that turn it by some degrees. Where it
    /// says that it saw where it is, it is there.
    private static Tracking through(Walls rooms, double x, double meters, double degrees) {
        var random = new SplittableRandom(3);
        var before = new Pose2d(x, 2.5, 0.05);
        Pose2d behind = before.compose(new Pose2d(meters, 0, 0.05));
        Pose2d reported = before.compose(new Pose2d(meters - 0.1, 0.25, 0.05 + Math.toRadians(degrees)));
        var slam = new Slam(Slam.Settings.DEFAULT);
        slam.add(before, rooms.scan(before, 0.01, random));
        Pose2d found = slam.pose(slam.add(reported, rooms.scan(behind, 0.01, random)));
        assertThat(!slam.tracking().seeing() || found.isNear(behind, 0.05, 0.02))
                .isTrue();
        return slam.tracking();
    }

    @Test
    void isLessSureTheFartherItDrivesBlindly() {
        var random = new SplittableRandom(5);
        Drive drive = part(drive(random), 0, 20, Pose2d.ORIGIN);
        Slam slam = run(Slam.Settings.DEFAULT, drive, random).slam();
        assertThat(slam.tracking().quality()).isEqualTo(Quality.LOCALIZED);
        double seeing = slam.tracking().covariance().positionDeviation();
        assertThat(seeing).isBetween(0.005, 0.06);

        Pose2d from = drive.odometry().getLast();
        double before = seeing;
        var words = new LinkedHashSet<Quality>();
        for (int i = 1; i <= 40; i++) {
            slam.add(from.compose(new Pose2d(0.25 * i, 0, 0)), new Walls().scan(Pose2d.ORIGIN, 0, random));
            words.add(slam.tracking().quality());
            double deviation = slam.tracking().covariance().positionDeviation();
            assertThat(deviation).isGreaterThan(before);
            before = deviation;
        }
        assertThat(before).isBetween(0.5, 5.0); // 10 m without seeing anything
        assertThat(words).containsExactly(Quality.LOCALIZED, Quality.AMBIGUOUS, Quality.LOST);
    }

    @Test
    void whatItMapsAfterABlindDriveIsAmbiguousUntilALoopCloses() {
        var random = new SplittableRandom(11);
        Drive drive = drive(random);
        var slam = new Slam(Slam.Settings.DEFAULT);
        var words = new ArrayList<Quality>();
        for (int i = 0; i < drive.truth().size(); i++) {
            boolean blind = i >= 30 && i < 36;
            Walls walls = blind ? new Walls() : FLOOR;
            slam.add(drive.odometry().get(i), walls.scan(drive.truth().get(i), 0.01, random));
            words.add(slam.tracking().quality());
            if (i == 60) {
                assertThat(slam.tracking().covariance().positionDeviation()).isLessThan(0.1);
            }
        }

        assertThat(words.get(29)).isEqualTo(Quality.LOCALIZED);
        assertThat(words.get(60)).isEqualTo(Quality.AMBIGUOUS);
        assertThat(words.getLast()).isEqualTo(Quality.LOCALIZED);
    }

    @Test
    void isLostWhenWhatItSeesDoesNotFitForLong() {
        var random = new SplittableRandom(5);
        Drive drive = part(drive(random), 0, 20, Pose2d.ORIGIN);
        Slam slam = run(Slam.Settings.DEFAULT, drive, random).slam();
        Pose2d here = drive.odometry().getLast();
        var covered = new Walls().chain(0.2, -0.3, 0.25, 0.1, 0.15, 0.4);
        for (int i = 0; i < 20; i++) {
            slam.add(here, covered.scan(Pose2d.ORIGIN, 0, random));
        }
        assertThat(slam.tracking().quality()).isEqualTo(Quality.LOST);
        assertThat(slam.tracking().confidence()).isLessThan(0.3);
    }

    @Test
    void isUnsureAlongACorridorWithoutEndsAndStaysWhereTheWheelsSay() {
        var random = new SplittableRandom(5);
        var corridor = new Walls().chain(-100, -1, 100, -1).chain(-100, 1, 100, 1);
        var slam = new Slam(Slam.Settings.DEFAULT.within(15));
        var end = new Pose2d(0, 0, 0);
        for (int i = 0; i < 40; i++) {
            var place = new Pose2d(0.3 * i, 0, 0);
            end = slam.pose(slam.add(place, corridor.scan(place, 0.01, random)));
        }

        assertThat(end.x()).isCloseTo(11.7, within(0.1));
        Covariance2d covariance = slam.tracking().covariance();
        assertThat(Math.sqrt(covariance.xx())).isGreaterThan(0.1);
        assertThat(Math.sqrt(covariance.yy())).isLessThan(0.03);
        assertThat(slam.tracking().quality()).isEqualTo(Quality.AMBIGUOUS);
    }

    @Test
    void seesParallelWallsThoughTheyDoNotShowHowFarItIsAlongThem() {
        var random = new SplittableRandom(5);
        var hall = new Walls().chain(-100, -2, 100, -2).chain(-100, 2, 100, 2);
        var slam = new Slam(Slam.Settings.DEFAULT.within(4));
        int seen = 0;
        for (int i = 0; i < 100; i++) {
            var place = new Pose2d(0.04 * i, 0, 0.1);
            Pose2d found = slam.pose(slam.add(place, hall.scan(place, 0.01, random)));
            assertThat(found.isNear(place, 0.1, 0.02)).isTrue();
            seen += slam.tracking().seeing() ? 1 : 0;
        }

        assertThat(seen).isGreaterThan(90);
    }

    @Test
    void scansThatShowNothingLeaveItToTheWheels() {
        var nowhere = new Walls();
        var slam = new Slam(Slam.Settings.DEFAULT);
        for (int i = 0; i < 10; i++) {
            var located = slam.add(new Pose2d(i, 0, 0), nowhere.scan(Pose2d.ORIGIN, 0, new SplittableRandom(1)));
            assertThat(slam.pose(located).isNear(new Pose2d(i, 0, 0), 1e-9, 1e-9))
                    .isTrue();
        }
        slam.polish(1);
        assertThat(slam.poses()).hasSize(10);
    }

    @Test
    void mapsOfTwoRobotsBecomeOne() {
        var random = new SplittableRandom(4);
        Drive drive = drive(random);
        Slam first = run(Slam.Settings.DEFAULT, part(drive, 0, 90, Pose2d.ORIGIN), random)
                .slam();
        var elsewhere = new Pose2d(-40, 12, 2.5);
        Run second = run(Slam.Settings.DEFAULT, part(drive, 50, 150, elsewhere), random);

        Merge merge = first.merge(second.slam());

        assertThat(merge).isInstanceOf(Merge.Done.class);
        Pose2d firstFromSecond = ((Merge.Done) merge).mapFromOther();

        assertThat(firstFromSecond
                        .compose(second.poses().get(20))
                        .isNear(drive.truth().get(70), 0.5, 0.05))
                .isTrue();
        OccupancyGrid map = first.map(ScanMapper.Settings.of(0.1));
        assertThat(map.width() * map.resolution()).isBetween(26.0, 28.0);
        assertThat(map.isFree(1.2, 8)).isTrue(); // seen by the second alone
    }

    /// 10 m × 6 m; half a turn about its middle makes the same of it.
    private static Walls halfTurned() {
        return new Walls()
                .box(0, 0, 10, 6)
                .box(2, 1.5, 2.6, 2)
                .box(7.4, 4, 8, 4.5)
                .box(0, 4.5, 1, 6)
                .box(9, 0, 10, 1.5);
    }

    private static Slam acrossTheRoom(Walls room, Pose2d start, Pose2d reported, SplittableRandom random) {
        var slam = new Slam(Slam.Settings.DEFAULT);
        for (int i = 0; i < 20; i++) {
            var way = new Pose2d(0.3 * i, 0, 0);
            slam.add(reported.compose(way), room.scan(start.compose(way), 0.01, random));
        }
        for (int i = 1; i <= 6; i++) {
            var way = new Pose2d(5.7, 0, i * Math.PI / 6);
            slam.add(reported.compose(way), room.scan(start.compose(way), 0.01, random));
        }
        return slam;
    }

    @Test
    void mapsThatFitInTwoWaysStayTwoAndBothWaysAreReported() {
        var random = new SplittableRandom(4);
        var start = new Pose2d(2, 3, 0.1);
        Slam first = acrossTheRoom(halfTurned(), start, start, random);
        var reported = new Pose2d(-5, 2, 1);
        Slam second = acrossTheRoom(halfTurned(), new Pose2d(8, 3.4, 3), reported, random);
        int before = first.frameCount();

        Merge merge = first.merge(second);

        assertThat(merge).isInstanceOf(Merge.Ambiguous.class);
        var ambiguous = (Merge.Ambiguous) merge;
        Pose2d one = ambiguous.mapFromOther().compose(reported);
        Pose2d other = ambiguous.rival().compose(reported);
        var right = new Pose2d(8, 3.4, 3);
        var halfATurn = new Pose2d(2, 2.6, 3 - Math.PI);
        assertThat(List.of(one, other))
                .anyMatch(pose -> pose.isNear(right, 0.2, 0.05))
                .anyMatch(pose -> pose.isNear(halfATurn, 0.2, 0.05));
        assertThat(first.frameCount()).isEqualTo(before);
    }

    @Test
    void aCabinetThatStandsOnOneSideOnlyDistinguishesTheWays() {
        var random = new SplittableRandom(4);
        var start = new Pose2d(2, 3, 0.1);
        Walls room = halfTurned().box(4, 5.2, 5.4, 6);
        Slam first = acrossTheRoom(room, start, start, random);
        var reported = new Pose2d(-5, 2, 1);
        Slam second = acrossTheRoom(room, new Pose2d(8, 3.4, 3), reported, random);

        assertThat(first.merge(second))
                .isInstanceOfSatisfying(
                        Merge.Done.class,
                        done -> assertThat(
                                        done.mapFromOther().compose(reported).isNear(new Pose2d(8, 3.4, 3), 0.2, 0.05))
                                .isTrue());
    }

    /// 5.5 m × 6 m with a door below and a cabinet in a corner.
    private static Walls room(double door) {
        return new Walls()
                .chain(door - 0.45, 0, 0, 0, 0, 6, 5.5, 6, 5.5, 0, door + 0.45, 0)
                .chain(door - 0.45, 0, door - 0.45, -2, -8, -2)
                .chain(door + 0.45, -2, 9, -2)
                .box(0, 4.8, 1, 6); // or half a turn would fit, too
    }

    private static Slam around(Walls room, SplittableRandom random) {
        var slam = new Slam(Slam.Settings.DEFAULT);
        for (int i = 0; i < 36; i++) {
            double bearing = i * Math.PI / 18;
            var pose = new Pose2d(2.75 + 1.5 * Math.sin(bearing), 2 - 1.2 * Math.cos(bearing), bearing);
            slam.add(pose, room.scan(pose, 0.01, random));
        }
        return slam;
    }

    @LongTest
    @Test
    void likeRoomsWithOtherFurnitureStayTwo() {
        var random = new SplittableRandom(4);
        Slam first = around(room(3).box(2, 4, 3, 5), random);
        Slam second = around(room(2.5).box(3.5, 3.6, 5.5, 4.2), random);
        List<Pose2d> poses = first.poses();
        List<Relation> relations = first.relations();
        int fits = first.fits();
        byte[] map = first.map(ScanMapper.Settings.of(0.1)).cells();

        assertThat(first.merge(second)).isInstanceOf(Merge.Contradicted.class);
        assertThat(first.poses()).isEqualTo(poses);
        assertThat(first.relations()).isEqualTo(relations);
        assertThat(first.fits()).isEqualTo(fits);
        assertThat(first.map(ScanMapper.Settings.of(0.1)).cells()).isEqualTo(map);
    }

    @Test
    void aBoxThatWasMovedContradictsAndTheRoomsBecomeOneNevertheless() {
        var random = new SplittableRandom(4);
        Slam first = around(room(3).box(2, 4, 3, 5), random);
        Slam second = around(room(3).box(2, 4, 3, 5).box(4, 4, 4.8, 4.8), random);
        int before = first.frameCount();

        assertThat(first.merge(second)).isInstanceOfSatisfying(Merge.Contradicted.class, refused -> {
            assertThat(refused.mapFromOther().isNear(Pose2d.ORIGIN, 0.1, 0.03)).isTrue();
            assertBoxIsReported(refused.shared(), before);
        });
        assertThat(first.frameCount()).isEqualTo(before);

        assertThat(first.mergeDespiteContradictions(second)).isInstanceOfSatisfying(Merge.Done.class, done -> {
            assertThat(done.mapFromOther().isNear(Pose2d.ORIGIN, 0.1, 0.03)).isTrue();
            assertBoxIsReported(done.shared(), before);
        });
        assertThat(first.frameCount()).isEqualTo(before + second.frameCount());
    }

    private static void assertBoxIsReported(MapOverlap shared, int firstOfSecond) {
        assertThat(shared.isContradicted()).isTrue();
        assertThat(shared.against()).isBetween(MapOverlap.MOST_AGAINST, 0.2);
        assertThat(shared.worst()).hasValueSatisfying(worst -> {
            assertThat(worst.x()).isBetween(3.9, 4.9);
            assertThat(worst.y()).isBetween(3.9, 4.9);
            assertThat(worst.hitBy()).isGreaterThanOrEqualTo(firstOfSecond);
            assertThat(worst.freeBy()).isLessThan(firstOfSecond);
        });
    }

    @Test
    void whatSharesNothingStaysTwoDespiteContradictions() {
        var random = new SplittableRandom(4);
        Slam first = around(room(3), random);

        assertThat(first.mergeDespiteContradictions(new Slam(Slam.Settings.DEFAULT)))
                .isEqualTo(new Merge.Apart());
    }

    @Test
    void aRoomAndTheSameRoomBecomeOne() {
        var random = new SplittableRandom(4);
        Slam first = around(room(3).box(2, 4, 3, 5), random);
        Slam second = around(room(3).box(2, 4, 3, 5), random);

        assertThat(first.merge(second)).isInstanceOfSatisfying(Merge.Done.class, done -> {
            assertThat(done.mapFromOther().isNear(Pose2d.ORIGIN, 0.1, 0.03)).isTrue();
            assertThat(done.shared().squareMeters()).isBetween(20.0, 45.0);
            assertThat(done.shared().against()).isLessThan(0.01);
        });
    }

    @Test
    void mapsWithNothingInCommonStayTwo() {
        var random = new SplittableRandom(4);
        Drive drive = drive(random);
        Slam first = run(Slam.Settings.DEFAULT, part(drive, 0, 40, Pose2d.ORIGIN), random)
                .slam();
        var other = new Slam(Slam.Settings.DEFAULT);
        for (int i = 0; i < 5; i++) {
            other.add(new Pose2d(i, 0, 0), new Walls().chain(2, -1, 3, 0, 2, 1).scan(Pose2d.ORIGIN, 0.01, random));
        }

        assertThat(first.merge(other)).isEqualTo(new Merge.Apart());
        assertThat(first.merge(new Slam(Slam.Settings.DEFAULT))).isEqualTo(new Merge.Apart());
        assertThat(first.frameCount()).isEqualTo(first.poses().size());
    }

    private static Drive part(Drive drive, int from, int to, Pose2d shift) {
        return new Drive(
                drive.truth().subList(from, to),
                drive.odometry().subList(from, to).stream().map(shift::compose).toList());
    }

    @Test
    void refusesOdometryThatIsNoPlace() {
        var scan = FLOOR.scan(new Pose2d(1, 1, 0), 0, new SplittableRandom(1));

        assertThatThrownBy(() -> new Slam(Slam.Settings.DEFAULT).add(new Pose2d(Double.NaN, 0, 0), scan))
                .hasMessageContaining("NaN");
    }
}
