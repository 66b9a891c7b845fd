package rsal.agent.team;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.NavigableMap;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.IntStream;

/// Divides jobs among members, each of which does its part one after the other: an open travelling-salesmen problem,
/// where a way costs each member something else. A few jobs are divided exactly ([ExactRoutes]), of more one after
/// another is put where it costs least (as bids in auctions
/// of single items have it), then single jobs and ends of routes are moved and changed over as long as that makes it
/// better, then jobs that are near each other are taken out together and put back, and the jobs of a few members are
/// divided exactly. Same estimates, same answer.
///
/// Source: M. G. Lagoudakis et al., "Auction-based multi-robot routing" (2005) for the two objectives and the
/// insertion; the moves are those customary in vehicle routing (P. Toth and D. Vigo, "Vehicle Routing", 2014, ch.
/// 4); taking out and putting back after G. Schrimpf et al., "Record breaking optimization results using the ruin
/// and recreate principle" (2000), with neighborhoods of each job in turn instead of random ones.
public final class JobRoutes {
    private static final double WORTH_IT = 1e-9; // m
    private static final double AS_GOOD = 1.01; // times as long
    private static final int MOST_NEIGHBORS = 6;
    static final double SUM_IN_LONGEST = 1e-3; // of equal longest routes the one with the least sum

    private final Objective objective;
    private final List<String> names;
    private final Estimate[] estimates;
    private final List<List<Integer>> routes = new ArrayList<>();
    private boolean direct; // else squares are made less, which shows the way where the longest route stays the same

    private JobRoutes(SortedMap<String, Estimate> members, Objective objective, boolean direct) {
        this.objective = objective;
        this.direct = direct;
        this.names = List.copyOf(members.keySet());
        this.estimates = members.values().toArray(Estimate[]::new);
        names.forEach(_ -> routes.add(new ArrayList<>()));
    }

    /// @param members what they would cost, by name, for the same jobs, in routes
    /// @return numbers of jobs in order for those who get any; without jobs that nobody can do
    public static SortedMap<String, List<Integer>> divide(NavigableMap<String, Estimate> members, Objective objective) {
        if (members.isEmpty()) {
            return new TreeMap<>();
        }
        int jobs = members.firstEntry().getValue().first().size();
        return jobs <= ExactRoutes.MOST_JOBS ? ExactRoutes.divide(members, objective) : search(members, objective);
    }

    /// For any number of jobs, and near the best.
    static SortedMap<String, List<Integer>> search(SortedMap<String, Estimate> members, Objective objective) {
        var direct = new JobRoutes(members, objective, true);
        direct.search();
        var guided = new JobRoutes(members, objective, false);
        guided.search();
        guided.direct = true;
        guided.search();
        return direct.total() <= guided.total() ? direct.divided() : guided.divided();
    }

    private void search() {
        if (routes.stream().allMatch(List::isEmpty)) {
            insert(IntStream.range(0, estimates[0].first().size()).boxed().toList());
        }
        double before;
        do {
            before = total();
            improve();
            recreate();
            redivide();
        } while (total() < before - WORTH_IT);
    }

    private SortedMap<String, List<Integer>> divided() {
        var divided = new TreeMap<String, List<Integer>>();
        for (int i = 0; i < names.size(); i++) {
            if (!routes.get(i).isEmpty()) {
                divided.put(names.get(i), List.copyOf(routes.get(i)));
            }
        }
        return divided;
    }

    /// What a route costs the one that does it [m]; 0 for none.
    public static double cost(Estimate estimate, List<Integer> route) {
        double sum = 0;
        for (int i = 0; i < route.size(); i++) {
            sum += i == 0
                    ? estimate.first().get(route.get(0))
                    : estimate.after().get(route.get(i - 1)).get(route.get(i));
        }
        return sum;
    }

    /// Of a route's jobs the one that costs least to begin with, if the route is as good with that one first: what is
    /// near is done while what is far may still go to somebody else. So it is wherever jobs all end at one place.
    static int next(Estimate estimate, List<Integer> route) {
        double most = AS_GOOD * cost(estimate, route);
        return route.stream()
                .sorted(Comparator.comparingDouble(estimate.first()::get))
                .filter(job -> cost(estimate, withFirst(job, route)) <= most)
                .findFirst()
                .orElseThrow(); // its own first one
    }

    private static List<Integer> withFirst(Integer job, List<Integer> route) {
        var other = new ArrayList<>(route);
        other.remove(/* element */ job);
        other.addFirst(job);
        return other;
    }

    private double cost(int member) {
        return cost(estimates[member], routes.get(member));
    }

    private double total() {
        double sum = 0;
        double squares = 0;
        double longest = 0;
        for (int member = 0; member < estimates.length; member++) {
            double cost = cost(member);
            sum += cost;
            squares += cost * cost;
            longest = Math.max(longest, cost);
        }
        if (objective == Objective.SUM) {
            return sum;
        }
        return direct ? longest + SUM_IN_LONGEST * sum : squares;
    }

    /// Puts jobs where they cost least, the one that costs least first.
    private void insert(List<Integer> jobs) {
        var left = new ArrayList<>(jobs);
        while (!left.isEmpty()) {
            var cheapest = left.stream()
                    .map(this::cheapestPlace)
                    .min(Comparator.comparingDouble(Insertion::total))
                    .orElseThrow();
            if (cheapest.total == Double.POSITIVE_INFINITY) {
                return; // nobody can do the rest
            }
            routes.get(cheapest.member).add(cheapest.position, cheapest.job);
            left.remove(/* element */ cheapest.job);
        }
    }

    private Insertion cheapestPlace(Integer job) {
        var best = new Insertion(job, 0, 0, Double.POSITIVE_INFINITY);
        for (int member = 0; member < estimates.length; member++) {
            List<Integer> route = routes.get(member);
            for (int position = 0; position <= route.size(); position++) {
                route.add(position, job);
                double total = total();
                route.remove(/* index */ position);
                if (total < best.total - WORTH_IT) {
                    best = new Insertion(job, member, position, total);
                }
            }
        }
        return best;
    }

    private void improve() {
        double before = total();
        double now = before;
        do {
            before = now;
            for (int member = 0; member < estimates.length; member++) {
                moveOne(member);
                exchangeEnds(member);
                turnPieces(member);
            }
            swapAny();
            now = total();
        } while (now < before - WORTH_IT);
    }

    /// Takes out each job with its neighbors and puts them back, as long as that makes it better.
    private void recreate() {
        List<Integer> done = routes.stream().flatMap(List::stream).toList();
        for (int size = 2; size <= Math.min(MOST_NEIGHBORS, done.size()); size++) {
            for (Integer center : done) {
                List<List<Integer>> before = routes.stream().map(List::copyOf).toList();
                double total = total();
                List<Integer> out = neighbors(center, done).subList(0, size);
                routes.forEach(route -> route.removeAll(out));
                insert(out);
                improve();
                if (total() >= total - WORTH_IT) {
                    for (int member = 0; member < estimates.length; member++) {
                        routes.set(member, new ArrayList<>(before.get(member)));
                    }
                }
            }
        }
    }

    /// Those that are soonest done after a job by anybody, itself first.
    private List<Integer> neighbors(Integer center, List<Integer> jobs) {
        return jobs.stream()
                .sorted(Comparator.comparingDouble((Integer job) -> job.equals(center) ? -1 : leastAfter(center, job)))
                .toList();
    }

    private double leastAfter(Integer one, Integer next) {
        return Arrays.stream(estimates)
                .mapToDouble(estimate -> estimate.after().get(one).get(next))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    /// Divides the jobs of any two or three members exactly, where these are few.
    private void redivide() {
        for (int a = 0; a < estimates.length; a++) {
            for (int b = 0; b < a; b++) {
                redivide(List.of(a, b));
                for (int c = 0; c < b; c++) {
                    redivide(List.of(a, b, c));
                }
            }
        }
    }

    private void redivide(List<Integer> members) {
        List<Integer> theirs =
                members.stream().flatMap(member -> routes.get(member).stream()).toList();
        if (theirs.isEmpty() || theirs.size() > ExactRoutes.MOST_JOBS) {
            return;
        }
        var some = new TreeMap<String, Estimate>();
        members.forEach(member -> some.put(names.get(member), estimates[member].of(theirs)));
        var divided = ExactRoutes.divide(some, objective);
        double before = total();
        List<List<Integer>> old = List.copyOf(routes);
        for (int member : members) {
            List<Integer> route = divided.getOrDefault(names.get(member), List.of());
            routes.set(member, new ArrayList<>(route.stream().map(theirs::get).toList()));
        }
        if (total() >= before - WORTH_IT) {
            members.forEach(member -> routes.set(member, old.get(member)));
        }
    }

    /// Puts each job of a route where it costs least, if that is elsewhere.
    private void moveOne(int member) {
        List<Integer> route = routes.get(member);
        for (int position = 0; position < route.size(); position++) {
            double before = total();
            Integer job = route.remove(/* index */ position);
            Insertion best = cheapestPlace(job);
            if (best.total < before - WORTH_IT) {
                routes.get(best.member).add(best.position, job);
                position = -1; // begin again
            } else {
                route.add(position, job);
            }
        }
    }

    /// Changes over the ends of two routes, one of which may be all of it or nothing.
    private void exchangeEnds(int member) {
        for (int other = member + 1; other < estimates.length; other++) {
            List<Integer> mine = List.copyOf(routes.get(member));
            List<Integer> theirs = List.copyOf(routes.get(other));
            double best = total();
            List<Integer> bestMine = mine;
            List<Integer> bestTheirs = theirs;
            for (int i = 0; i <= mine.size(); i++) {
                for (int j = 0; j <= theirs.size(); j++) {
                    routes.set(member, joined(mine.subList(0, i), theirs.subList(j, theirs.size())));
                    routes.set(other, joined(theirs.subList(0, j), mine.subList(i, mine.size())));
                    double total = total();
                    if (total < best - WORTH_IT) {
                        best = total;
                        bestMine = routes.get(member);
                        bestTheirs = routes.get(other);
                    }
                }
            }
            routes.set(member, new ArrayList<>(bestMine));
            routes.set(other, new ArrayList<>(bestTheirs));
        }
    }

    private static List<Integer> joined(List<Integer> begin, List<Integer> end) {
        var route = new ArrayList<>(begin);
        route.addAll(end);
        return route;
    }

    /// Does a piece of a route the other way around.
    private void turnPieces(int member) {
        for (int from = 0; from < routes.get(member).size(); from++) {
            for (int to = from + 2; to <= routes.get(member).size(); to++) {
                List<Integer> before = routes.get(member);
                double cost = total();
                var turned = new ArrayList<>(before);
                turned.subList(from, to).clear();
                turned.addAll(from, before.subList(from, to).reversed());
                routes.set(member, turned);
                if (total() >= cost - WORTH_IT) {
                    routes.set(member, before);
                }
            }
        }
    }

    /// Changes over two jobs, wherever they are.
    private void swapAny() {
        for (int a = 0; a < estimates.length; a++) {
            for (int b = a; b < estimates.length; b++) {
                List<Integer> one = routes.get(a);
                List<Integer> other = routes.get(b);
                for (int i = 0; i < one.size(); i++) {
                    for (int j = 0; j < other.size(); j++) {
                        double before = total();
                        swap(one, i, other, j);
                        if (total() >= before - WORTH_IT) {
                            swap(one, i, other, j);
                        }
                    }
                }
            }
        }
    }

    private static void swap(List<Integer> one, int i, List<Integer> other, int j) {
        Integer job = one.get(i);
        one.set(i, other.get(j));
        other.set(j, job);
    }

    private record Insertion(Integer job, int member, int position, double total) {}
}
