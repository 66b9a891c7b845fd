package rsal.bench.navigation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import rsal.bench.measurement.AllCores;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.navigation.TightTrip.Outcome;

/// The navigator where there is little room, with Pioneers whose lasers don't look behind. Each repeat has another
/// seed. Names are `navigator.<where>.<planner>.<what>`, by the local planner:
/// * `door.….goals`, `.contacts`: goals that four reach in ten minutes who are sent through a door of 0.8 m, and how
///   often they touch something ([DoorRun]);
/// * `nook.….reached`, `.seconds`, `.contacts`: share of the trips out of a nook, and to behind its end, that get there
///   within five minutes, the time of these in the mean, and how often something is touched
///   ([TightTrip#outOfANook]);
/// * `near.….reached`, `.seconds`, `.contacts`: the same of 40 trips from beside things, within 200 s
///   ([TightTrip#besideThings]).
public final class TightBench implements Bench {
    private static final List<String> PLANNERS = List.of("vfh", "nd", "snd", "dwa", "mpc");
    private static final Duration AT_THE_DOOR = Duration.ofMinutes(10);
    private static final Duration IN_THE_NOOK = Duration.ofMinutes(5);
    private static final Duration BESIDE_THINGS = Duration.ofSeconds(200);
    private static final int TRIPS = 40;

    /// @param goals reached
    private record Crossing(int goals, int contacts) {}

    private static List<String> names(String where, String planner) {
        List<String> whats =
                where.equals("door") ? List.of("goals", "contacts") : List.of("reached", "seconds", "contacts");
        return whats.stream()
                .map(what -> "navigator.%s.%s.%s".formatted(where, planner, what))
                .toList();
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        for (String where : List.of("door", "nook", "near")) {
            PLANNERS.forEach(planner -> names.addAll(names(where, planner)));
        }
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (String planner : PLANNERS) {
            measureDoor(planner, assignment);
        }
        for (String planner : PLANNERS) {
            measureTrips("nook", planner, IN_THE_NOOK, TightTrip::outOfANook, assignment);
        }
        for (String planner : PLANNERS) {
            measureTrips("near", planner, BESIDE_THINGS, seed -> TightTrip.besideThings(TRIPS, seed), assignment);
        }
    }

    private static void measureDoor(String planner, BenchmarkRequest assignment) {
        List<String> names = names("door", planner);
        if (assignment.wantsAny(names)) {
            List<Crossing> runs = eachSeed(names, assignment, seed -> {
                try (var run = new DoorRun(planner, seed)) {
                    run.run(AT_THE_DOOR);
                    return new Crossing(run.reached(), run.contacts());
                }
            });
            assignment.report(
                    Result.more(names.get(0), "", each(runs, Crossing::goals)),
                    Result.less(names.get(1), "", each(runs, Crossing::contacts)));
        }
    }

    private static void measureTrips(
            String where,
            String planner,
            Duration longest,
            LongFunction<List<TightTrip>> trips,
            BenchmarkRequest assignment) {
        List<String> names = names(where, planner);
        if (!assignment.wantsAny(names)) {
            return;
        }
        List<List<Outcome>> runs = eachSeed(
                names,
                assignment,
                seed -> trips.apply(seed).stream()
                        .map(trip -> trip.drive(planner, longest))
                        .toList());
        assignment.report(Result.more(
                names.get(0), "", each(runs, driven -> (double) times(driven).length / driven.size())));
        double[] seconds = runs.stream()
                .flatMapToDouble(driven -> DoubleStream.of(times(driven)).average().stream())
                .toArray();
        if (seconds.length > 0) {
            assignment.report(Result.less(names.get(1), "s", seconds));
        } else {
            assignment.notes().accept("Skipped '%s': no trip got there.".formatted(names.get(1)));
        }
        assignment.report(Result.less(
                names.get(2),
                "",
                each(runs, driven -> driven.stream().mapToInt(Outcome::contacts).sum())));
    }

    /// Of those that got there [s].
    private static double[] times(List<Outcome> trips) {
        return trips.stream()
                .filter(Outcome::reached)
                .mapToDouble(Outcome::seconds)
                .toArray();
    }

    private static <T> List<T> eachSeed(List<String> names, BenchmarkRequest assignment, LongFunction<T> run) {
        List<Long> seeds =
                LongStream.rangeClosed(1, assignment.repeats()).boxed().toList();
        String what = names.getFirst().substring(0, names.getFirst().lastIndexOf('.'));
        return AllCores.each("tight", seeds, run::apply, done -> assignment.reach(what, done, seeds.size()));
    }

    private static <T> double[] each(List<T> runs, ToDoubleFunction<T> what) {
        return runs.stream().mapToDouble(what).toArray();
    }
}
