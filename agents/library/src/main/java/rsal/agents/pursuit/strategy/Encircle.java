package rsal.agents.pursuit.strategy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Hunters that cut off prey: the nearest one chases, and each other one goes where it leaves the prey least. All chase
/// while none is near enough that the prey may flee.
///
/// A hunter compares the prey's own place with places within [#REACH] of it. Where the team will be after [#AHEAD], if
/// the others drive where they announced, some places are left that the prey reaches before any hunter; the hunter
/// drives where the last of these is reached by hunters soonest ([PursuitModel#freedom]). As all do so by what the
/// others
/// announced last, each closes a way that no other one closes. Prey that nobody sees are searched for ([BeliefSearch]).
///
/// One that always chases keeps the team from waiting for ever at the ends of ways: without it, one of 40 hunts in an
/// ideal model did not end.
public final class Encircle implements PursuitStrategyType {
    static final Parameter<Double> HUNTER_SPEED =
            Parameter.number("hunterSpeed", 0.6, 0.05, 10, "m/s", "Speed of hunters that it assumes.");
    static final Parameter<Double> PREY_SPEED =
            Parameter.number("preySpeed", 0.4, 0.05, 10, "m/s", "Speed of prey that it assumes.");
    private static final List<Integer> CHASE_ONLY = List.of(PursuitModel.CHASE);
    private static final double REACH = 20; // m of path from the prey
    private static final double APART = 2.5; // m of path between two places to compare
    private static final double ALERT = 8.0; // m of path from the nearest hunter, from where a prey may flee
    private static final double CLOSE = 3.0; // m of path, from where it only chases
    private static final double KEEP = 2.0; // s by which another goal has to be better
    private static final double AHEAD = 2.0; // s until the moment that it judges places by
    private static final double LEAD = 1.0; // s by which it drives before a moving prey

    @Override
    public String key() {
        return "clever";
    }

    @Override
    public String description() {
        return "Hunters search for unseen prey, cut off and surround known ones by messages about their goals, and"
                + " close in.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(HUNTER_SPEED, PREY_SPEED);
    }

    @Override
    public PursuitStrategy create(Arguments arguments) {
        return new Hunter(arguments);
    }

    private static final class Hunter implements PursuitStrategy {
        private final double hunterSpeed;
        private final double preySpeed;
        private final Direction direction = new Direction();
        private Optional<Model> model = Optional.empty();
        private int target = PursuitModel.CHASE;

        private record Model(FloorGraph floor, PursuitModel game, BeliefSearch search) {}

        Hunter(Arguments arguments) {
            this.hunterSpeed = arguments.get(HUNTER_SPEED);
            this.preySpeed = arguments.get(PREY_SPEED);
        }

        @Override
        public Optional<PursuitOrder> decide(PursuitView view) {
            if (model.isEmpty()) {
                model = view.floor()
                        .get()
                        .map(floor -> new Model(
                                floor,
                                new PursuitModel(floor, hunterSpeed, preySpeed, view.catchDistance()),
                                new BeliefSearch(floor, hunterSpeed, preySpeed)));
            }
            view.prey().forEach((prey, mapFromPrey) -> direction.note(prey, view.time(), mapFromPrey.position()));
            if (model.isEmpty()) {
                return view.direct();
            }
            model.get().search.update(view);
            Model known = model.get();
            Optional<PursuitOrder> hunt = view.assigned()
                    .flatMap(prey -> Optional.ofNullable(view.prey().get(prey))
                            .map(mapFromPrey -> hunt(known, view, prey, mapFromPrey)));
            return hunt.isPresent() ? hunt : known.search.decide(view);
        }

        private PursuitOrder hunt(Model model, PursuitView view, String prey, Pose2d mapFromPrey) {
            FloorGraph floor = model.floor;
            int preyAt = floor.nearest(mapFromPrey.position());
            int here = floor.nearest(view.mapFromBase().position());
            double[] toPrey = floor.distances(preyAt);
            if (toPrey[here] < CLOSE) {
                target = PursuitModel.CHASE;
                return PursuitOrder.hunt(prey, ahead(prey, mapFromPrey), "closing in on");
            }
            int self = 0;
            var hunters = new int[view.hunters().size()];
            var targets = new int[hunters.length];
            int i = 0;
            for (Map.Entry<String, Pose2d> hunter : view.hunters().entrySet()) {
                hunters[i] = floor.nearest(hunter.getValue().position());
                targets[i] = target(floor, view, hunter.getKey(), preyAt);
                if (hunter.getKey().equals(view.robot())) {
                    self = i;
                }
                i++;
            }
            int best = PursuitModel.CHASE;
            double least = Double.POSITIVE_INFINITY;
            int nearest = nearest(toPrey, hunters);
            boolean chases = self == nearest || toPrey[hunters[nearest]] > ALERT;
            for (int candidate : chases ? CHASE_ONLY : candidates(floor, toPrey, here)) {
                targets[self] = candidate;
                double freedom = model.game.freedom(preyAt, hunters, targets, AHEAD) - (candidate == target ? KEEP : 0);
                if (freedom < least) {
                    least = freedom;
                    best = candidate;
                }
            }
            target = best;
            if (best == PursuitModel.CHASE) {
                return PursuitOrder.hunt(prey, ahead(prey, mapFromPrey), "chasing");
            }
            Point2d goal = floor.place(best);
            return PursuitOrder.hunt(prey, new Pose2d(goal.x(), goal.y(), 0), "cutting off");
        }

        /// Which of the hunters is nearest to the prey, of equals the first.
        private static int nearest(double[] toPrey, int[] hunters) {
            int nearest = 0;
            for (int i = 1; i < hunters.length; i++) {
                nearest = toPrey[hunters[i]] < toPrey[hunters[nearest]] ? i : nearest;
            }
            return nearest;
        }

        /// What another hunter wants: one whose goal is near the prey chases it.
        private static int target(FloorGraph floor, PursuitView view, String hunter, int preyAt) {
            Point2d goal = view.goals().get(hunter);
            if (goal == null) {
                return PursuitModel.CHASE;
            }
            int place = floor.nearest(goal);
            return floor.distances(preyAt)[place] < CLOSE ? PursuitModel.CHASE : place;
        }

        private Pose2d ahead(String prey, Pose2d mapFromPrey) {
            Point2d velocity = direction.velocity(prey);
            return new Pose2d(
                    mapFromPrey.x() + LEAD * velocity.x(), mapFromPrey.y() + LEAD * velocity.y(), mapFromPrey.theta());
        }

        /// To chase, what it does now, and places around the prey, none near another.
        private List<Integer> candidates(FloorGraph floor, double[] toPrey, int here) {
            var candidates = new ArrayList<Integer>();
            candidates.add(PursuitModel.CHASE);
            if (target != PursuitModel.CHASE && target != here) {
                candidates.add(target);
            }
            for (int place = 0; place < floor.size(); place++) {
                if (toPrey[place] > REACH || toPrey[place] < 1) {
                    continue;
                }
                boolean apart = true;
                for (int i = 1; apart && i < candidates.size(); i++) {
                    apart = floor.distances(candidates.get(i))[place] >= APART;
                }
                if (apart) {
                    candidates.add(place);
                }
            }
            return candidates;
        }
    }
}
