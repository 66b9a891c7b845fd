package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.navigation.Drive.Tick;
import rsal.bench.place.Cave;
import rsal.bench.place.ChangedPlace;
import rsal.bench.place.ChangedPlace.Piece;
import rsal.bench.place.Floor;
import rsal.bench.place.Floorplan;
import rsal.bench.place.Office;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.Amcl.Settings;
import rsal.navigation.amcl.Beams;
import rsal.navigation.amcl.Kld;
import rsal.navigation.amcl.LocalizationMap;
import rsal.navigation.amcl.OdometryModel;

/// Whether localization knows when it is wrong, in places that differ from their maps.
///
/// Names are `amcl.honest.<case>.<what>`. Robots with a laser of 8 m drive for one or two minutes. All but those of
/// `anywhere` are told where they start. What is measured, over all ticks of all seeds:
/// * `rmse`, `p95`: error of the position [m];
/// * `sure`: share of the ticks that are *localized*;
/// * `lies`: share of the ticks that are *localized* with an error above 0.5 m;
/// * `falselyLost`: share of the ticks that are *lost* with an error below 0.2 m.
public final class HonestyBench implements Bench {
    private static final List<String> WHAT = List.of("rmse", "p95", "sure", "lies", "falselyLost");
    private static final double WRONG = 0.5; // m
    private static final double RIGHT = 0.2; // m
    private static final int MINUTE = 600; // ticks
    private static final int PIECES = 80;
    private static final double PERSON = 0.25; // m, radius
    private static final OdometryModel ALMOST_PERFECT = new OdometryModel(0.01, 0.002, 0.004);

    /// How wheels err: noise, and factors on distances and turns.
    private record Wheels(OdometryModel noise, double distance, double turn) {
        static final Wheels USUAL = new Wheels(Drive.WHEELS, 1, 1);

        static Wheels scaled(double distance, double turn) {
            return new Wheels(Drive.WHEELS, distance, turn);
        }
    }

    /// What robots drive through, and what they know of it.
    private record Setting(OccupancyGrid world, OccupancyGrid map, Wheels wheels, int people, int ticks, Route route) {
        static Setting of(OccupancyGrid world, OccupancyGrid map) {
            return new Setting(world, map, Wheels.USUAL, 0, MINUTE, HonestyBench::tour);
        }

        Setting with(Wheels other) {
            return new Setting(world, map, other, people, ticks, route);
        }

        Setting withPeople(int count) {
            return new Setting(world, map, wheels, count, ticks, route);
        }

        Setting along(Route other) {
            return new Setting(world, map, wheels, people, ticks, other);
        }

        Setting during(int longer) {
            return new Setting(world, map, wheels, people, longer, route);
        }
    }

    private interface Route {
        List<Tick> drive(Drive drive, int ticks, SplittableRandom random);
    }

    private interface Maker {
        Setting make(SplittableRandom random);
    }

    private record Case(String name, Maker maker) {}

    private static final List<Case> CASES = List.of(
            new Case("office", random -> moved(Office.MAP, 0, random)),
            new Case("office.moved10", random -> moved(Office.MAP, 0.1, random)),
            new Case("office.moved30", random -> moved(Office.MAP, 0.3, random)),
            new Case("office.added", random -> added(Office.MAP, PIECES, random)),
            new Case("office.people", random -> moved(Office.MAP, 0.1, random).withPeople(6)),
            new Case("office.walls20", random -> walls(Office.MAP, 0.2, random)),
            new Case("office.scale125", random -> moved(Office.MAP, 0, random).with(Wheels.scaled(1.25, 1))),
            new Case("office.scale80", random -> moved(Office.MAP, 0.1, random).with(Wheels.scaled(0.8, 1))),
            new Case("office.turn125", random -> moved(Office.MAP, 0.1, random).with(Wheels.scaled(1.25, 1.25))),
            new Case("office.jump", random -> moved(Office.MAP, 0.1, random).along(HonestyBench::jumping)),
            new Case("office.kidnap", random -> moved(Office.MAP, 0, random).along(HonestyBench::carried)),
            new Case("office.kidnap30", random -> moved(Office.MAP, 0.3, random).along(HonestyBench::carried)),
            new Case("hospital.moved30", random -> moved(Floor.draw(840, 580, 0.05, 5), 0.3, random)),
            new Case("hospital.bad", HonestyBench::badlyDrawn),
            new Case("hospital.walls20", random -> walls(Floor.draw(840, 580, 0.05, 5), 0.2, random)),
            new Case("cave.added", random -> added(Cave.draw(30, 0.05, 3), PIECES / 2, random)),
            new Case("mirror.added", random -> added(ChangedPlace.mirrored(), PIECES / 4, random)),
            new Case(
                    "mirror.people",
                    random -> added(ChangedPlace.mirrored(), PIECES / 8, random).withPeople(6)),
            new Case("corridor", _ -> corridor()),
            new Case("corridor.scale125", _ -> corridor().with(Wheels.scaled(1.25, 1))),
            new Case("otherBuilding", _ -> Setting.of(Cave.draw(30, 0.05, 4), centered(Floor.draw(600, 600, 0.05, 6)))),
            new Case("otherOffice", _ -> Setting.of(Floor.draw(840, 580, 0.05, 5), Floor.draw(840, 580, 0.05, 9))));

    @Override
    public List<String> names() {
        return CASES.stream()
                .flatMap(one -> WHAT.stream().map(what -> name(one, what)))
                .toList();
    }

    private static String name(Case one, String what) {
        return "amcl.honest.%s.%s".formatted(one.name(), what);
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (Case one : CASES) {
            if (WHAT.stream().anyMatch(what -> assignment.wants(name(one, what)))) {
                Measured measured = measure(one, 10);
                assignment.report(
                        Result.less(name(one, "rmse"), "m", measured.rmse()),
                        Result.less(name(one, "p95"), "m", measured.p95()),
                        Result.more(name(one, "sure"), "", measured.share(Belief::isSure)),
                        Result.less(name(one, "lies"), "", measured.share(Belief::isLie)),
                        Result.less(name(one, "falselyLost"), "", measured.share(Belief::isFalselyLost)));
            }
        }
    }

    /// Beliefs of a case.
    record Measured(List<Belief> beliefs) {
        double rmse() {
            return Math.sqrt(beliefs.stream()
                    .mapToDouble(belief -> belief.error() * belief.error())
                    .average()
                    .orElseThrow());
        }

        double p95() {
            double[] errors =
                    beliefs.stream().mapToDouble(Belief::error).sorted().toArray();
            return errors[(int) (0.95 * errors.length)];
        }

        double share(Predicate<Belief> which) {
            return (double) beliefs.stream().filter(which).count() / beliefs.size();
        }
    }

    /// What a robot believed at a tick.
    record Belief(double error, Quality quality) {
        boolean isSure() {
            return quality == Quality.LOCALIZED;
        }

        boolean isLie() {
            return isSure() && error > WRONG;
        }

        boolean isFalselyLost() {
            return quality == Quality.LOST && error < RIGHT;
        }
    }

    /// Names of all cases.
    static List<String> cases() {
        return CASES.stream().map(Case::name).toList();
    }

    /// @param name of a case
    static Measured measure(String name, int seeds) {
        return measure(
                CASES.stream()
                        .filter(one -> one.name().equals(name))
                        .findFirst()
                        .orElseThrow(),
                seeds);
    }

    private static Measured measure(Case one, int seeds) {
        var beliefs = new ArrayList<Belief>();
        for (int seed = 1; seed <= seeds; seed++) {
            beliefs.addAll(run(one.maker(), seed));
        }
        return new Measured(beliefs);
    }

    private static List<Belief> run(Maker maker, long seed) {
        var random = new SplittableRandom(seed);
        Setting setting = maker.make(random);
        var drive = new Drive(setting.world());
        List<Tick> ticks = erring(setting.route().drive(drive, setting.ticks(), random), setting.wheels(), random);
        var amcl = new Amcl(new LocalizationMap(setting.map(), 0.1, 0.05), settings(), random.split());
        Pose2d odometry = ticks.getFirst().odomFromBase();
        PoseEstimate estimate = LocalizationBench.about(ticks.getFirst().mapFromBase());
        amcl.start(estimate);
        var beliefs = new ArrayList<Belief>();
        for (int i = 0; i < ticks.size(); i++) {
            Tick tick = ticks.get(i);
            LaserScan scan = drive.laser(tick.mapFromBase(), random);
            crowd(scan, setting.people(), i);
            Beams beams = Beams.of(scan, 60, 30);
            estimate = amcl.due(tick.odomFromBase(), () -> beams)
                    ? amcl.update(tick.odomFromBase(), beams)
                    : estimate.moved(odometry.inverse().compose(tick.odomFromBase()));
            odometry = tick.odomFromBase();
            beliefs.add(new Belief(estimate.mapFromBase().distanceTo(tick.mapFromBase()), estimate.quality()));
        }
        return beliefs;
    }

    /// As the device `amcl` has them if nobody says otherwise.
    private static Settings settings() {
        return new Settings(
                150, 5000, 15, 0.1, Math.toRadians(6), new OdometryModel(0.06, 0.05, 0.08), new Kld(0.05, 2.33));
    }

    /// People who walk along, 1 to 3 m from the laser, and around it.
    private static void crowd(LaserScan scan, int people, int tick) {
        for (int person = 0; person < people; person++) {
            double distance = 1 + 2.0 * person / people;
            double angle = (person + 0.5) * 2 * Math.PI / people + 0.02 * tick * (person % 2 == 0 ? 1 : -1);
            for (int beam = 0; beam < scan.count(); beam++) {
                double aside = distance * Math.sin(scan.angle(beam) - angle);
                double along = distance * Math.cos(scan.angle(beam) - angle);
                if (along > 0 && Math.abs(aside) < PERSON) {
                    float reached = (float) (along - Math.sqrt(PERSON * PERSON - aside * aside));
                    scan.ranges()[beam] = Math.min(scan.ranges()[beam], reached);
                }
            }
        }
    }

    private static List<Tick> erring(List<Tick> ticks, Wheels wheels, RandomGenerator random) {
        if (wheels.equals(Wheels.USUAL)) {
            return ticks;
        }
        var erring = new ArrayList<Tick>();
        Pose2d odometry = Pose2d.ORIGIN;
        Pose2d before = ticks.getFirst().mapFromBase();
        for (Tick tick : ticks) {
            Pose2d motion = before.inverse().compose(tick.mapFromBase());
            var measured = new Pose2d(
                    motion.x() * wheels.distance(), motion.y() * wheels.distance(), motion.theta() * wheels.turn());
            odometry = wheels.noise().sample(odometry, odometry, odometry.compose(measured), random);
            before = tick.mapFromBase();
            erring.add(new Tick(tick.mapFromBase(), odometry));
        }
        return erring;
    }

    private static List<Tick> tour(Drive drive, int ticks, SplittableRandom random) {
        return drive.tour(drive.anywhere(random), ticks, random);
    }

    private static List<Tick> carried(Drive drive, int ticks, SplittableRandom random) {
        return Drive.kidnapped(tour(drive, ticks / 2, random), tour(drive, ticks, random));
    }

    /// Wheels that once say to have made 5 m at a stroke.
    private static List<Tick> jumping(Drive drive, int ticks, SplittableRandom random) {
        List<Tick> driven = tour(drive, ticks, random);
        var jumped = new ArrayList<Tick>();
        Pose2d jump = Pose2d.polar(5, random.nextDouble(-Math.PI, Math.PI));
        for (int i = 0; i < driven.size(); i++) {
            Tick tick = driven.get(i);
            jumped.add(i < ticks / 2 ? tick : new Tick(tick.mapFromBase(), jump.compose(tick.odomFromBase())));
        }
        return jumped;
    }

    private static Setting moved(OccupancyGrid bare, double share, SplittableRandom random) {
        List<Piece> known = ChangedPlace.furniture(bare, PIECES, random);
        int stay = (int) Math.round((1 - share) * known.size());
        OccupancyGrid staying = ChangedPlace.with(bare, known.subList(0, stay));
        List<Piece> others = ChangedPlace.furniture(staying, known.size() - stay, random);
        return Setting.of(ChangedPlace.with(staying, others), ChangedPlace.with(bare, known));
    }

    private static Setting added(OccupancyGrid map, int pieces, SplittableRandom random) {
        return Setting.of(ChangedPlace.with(map, ChangedPlace.furniture(map, pieces, random)), map);
    }

    private static Setting walls(OccupancyGrid world, double share, SplittableRandom random) {
        return Setting.of(world, ChangedPlace.withWallsMoved(world, share, random));
    }

    private static Setting badlyDrawn(SplittableRandom random) {
        OccupancyGrid world = Floor.draw(840, 580, 0.05, 5);
        var start = new Point2d(12.5, 18);
        OccupancyGrid map = ChangedPlace.withBadPart(
                world, start.x(), start.y(), 4, Math.toRadians(random.nextDouble(8, 15)), random.nextDouble(1.05, 1.2));
        return new Setting(
                world,
                map,
                new Wheels(ALMOST_PERFECT, 1, 1),
                0,
                2 * MINUTE,
                (drive, ticks, r) ->
                        drive.tour(near(drive, start, r), ticks, r, place -> place.distanceTo(start) < 3.2));
    }

    private static Pose2d near(Drive drive, Point2d place, SplittableRandom random) {
        Pose2d found = drive.anywhere(random);
        while (found.position().distanceTo(place) > 2.5) {
            found = drive.anywhere(random);
        }
        return found;
    }

    private static Setting corridor() {
        OccupancyGrid map = Floorplan.room(70, 2).grid();
        return Setting.of(map, map)
                .during(2 * MINUTE)
                .along((drive, ticks, random) -> drive.shuttle(new Point2d(5, 1), new Point2d(60, 1), ticks, random));
    }

    private static OccupancyGrid centered(OccupancyGrid map) {
        return new OccupancyGrid(
                map.width(),
                map.height(),
                map.resolution(),
                -map.width() * map.resolution() / 2,
                -map.height() * map.resolution() / 2,
                map.cells());
    }
}
