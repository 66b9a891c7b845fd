package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import rsal.settings.Arguments;

/// Dynamic task assignment by single-item auctions (DTAP): A. Farinelli et al., "Distributed on-line dynamic
/// task assignment for multi-robot patrolling" (2017). Each robot reports who has which task by which award, so
/// that each computes all bids itself; the article's robots ask for them. A robot bids 0 for the place where it
/// goes; the article's do so for their next two. Awards of a task are numbered, as robots have no common clock (L.
/// Lamport, "Time, clocks, and the ordering of events in a distributed system", 1978).
public final class DynamicTasks implements PatrolStrategyType {
    private static final double HOP = 2; // s per place and neighbor on the path
    private static final int TRIES = 8;

    @Override
    public String key() {
        return "dtap";
    }

    @Override
    public String description() {
        return "Places are tasks that robots hand on to the one with the lowest bid: the distance from the center of its tasks times their number.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new Auctions();
    }

    private static final class Auctions implements PatrolStrategy {
        private int members;
        private int key; // of the members that owners are numbers of
        private int[] owner = {}; // member by place
        private int[] award = {}; // by place, how often it was handed on

        /// Of which members, the owner of each place, then the number of its award.
        @Override
        public int[] note() {
            return Stream.of(new int[] {key}, owner, award)
                    .flatMapToInt(Arrays::stream)
                    .toArray();
        }

        @Override
        public int next(PatrolView view) {
            int size = view.graph().size();
            if (owner.length != size || key != view.team()) {
                key = view.team();
                members = view.members();
                owner = new int[size];
                Arrays.setAll(owner, place -> place % members);
                award = new int[size];
            }
            listen(view, size);
            int[] hops = view.graph().hops(view.here());
            var refused = new boolean[size];
            for (int i = 0; i < Math.min(TRIES, size - 1); i++) {
                int wanted = Choices.best(
                        Choices.others(view),
                        place -> (refused[place] ? -1e9 : 0)
                                + view.idle(place)
                                - HOP * size * hops[place]
                                - 1e-3 * view.lengthTo(place));
                int winner = winner(view, wanted);
                give(wanted, winner);
                if (winner == view.self() || isUrgent(view, wanted)) {
                    return wanted;
                }
                refused[wanted] = true;
            }
            return Choices.best(Choices.around(view), view::idle);
        }

        /// Newer awards of others count, when they are of the same members; of two with the same number that to the
        /// lower member.
        private void listen(PatrolView view, int size) {
            for (int member = 0; member < members; member++) {
                int[] note = view.note(member);
                for (int place = 0; note.length == 1 + 2 * size && note[0] == key && place < size; place++) {
                    int its = note[1 + place];
                    int number = note[1 + size + place];
                    boolean isNewer = number > award[place] || (number == award[place] && its < owner[place]);
                    if (its >= 0 && its < members && isNewer) {
                        owner[place] = its;
                        award[place] = number;
                    }
                }
            }
        }

        private void give(int place, int winner) {
            if (owner[place] != winner) {
                owner[place] = winner;
                award[place]++;
            }
        }

        private int winner(PatrolView view, int place) {
            int best = view.self();
            double least = bid(view, view.self(), place);
            for (int member = 0; member < members; member++) {
                double bid = bid(view, member, place);
                if (bid < least) {
                    least = bid;
                    best = member;
                }
            }
            return best;
        }

        private double bid(PatrolView view, int member, int place) {
            if (view.next(member) == place && member != view.self()) {
                return 0;
            }
            List<Integer> tasks = new ArrayList<>();
            for (int task = 0; task < owner.length; task++) {
                if (owner[task] == member && task != place) {
                    tasks.add(task);
                }
            }
            return view.graph().length(center(view.graph(), tasks, view.at(member), place), place) * (tasks.size() + 1);
        }

        /// The task with the least sum of path lengths to the others; without tasks, where the member is.
        private static int center(PatrolGraph graph, List<Integer> tasks, int at, int otherwise) {
            int best = at == PatrolView.NONE ? otherwise : at;
            double least = Double.POSITIVE_INFINITY;
            for (int task : tasks) {
                double sum = 0;
                for (int other : tasks) {
                    sum += graph.length(task, other);
                }
                if (sum < least) {
                    least = sum;
                    best = task;
                }
            }
            return best;
        }

        /// A neighbor that nobody goes to, and that is idle for longer than most.
        private static boolean isUrgent(PatrolView view, int place) {
            double mean = view.meanIdle();
            double variance = 0;
            for (int each = 0; each < view.graph().size(); each++) {
                variance += Math.pow(view.idle(each) - mean, 2) / view.graph().size();
            }
            return view.intended(place) == 0
                    && view.idle(place) > mean + 2 * Math.sqrt(variance)
                    && Arrays.stream(Choices.around(view)).anyMatch(next -> next == place);
        }
    }
}
