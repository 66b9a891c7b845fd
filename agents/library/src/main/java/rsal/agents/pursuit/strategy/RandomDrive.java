package rsal.agents.pursuit.strategy;

import java.util.Optional;
import rsal.data.Point2d;
import rsal.settings.Arguments;

/// What each strategy has to beat.
public final class RandomDrive implements PursuitStrategyType {
    private static final double THERE = 1.0; // m
    private static final double LONGEST = 60; // s for one drive

    @Override
    public String key() {
        return "random";
    }

    @Override
    public String description() {
        return "To places of the floor at random. Prey are caught where hunters meet them.";
    }

    @Override
    public PursuitStrategy create(Arguments arguments) {
        return new PursuitStrategy() {
            private Optional<Point2d> mapFromGoal = Optional.empty();
            private double until; // s

            @Override
            public Optional<PursuitOrder> decide(PursuitView view) {
                boolean drives = mapFromGoal
                        .filter(goal -> view.mapFromBase().position().distanceTo(goal) > THERE)
                        .isPresent();
                if (!drives || view.time() > until) {
                    until = view.time() + LONGEST;
                    mapFromGoal = view.floor()
                            .get()
                            .map(floor -> floor.place(view.random().nextInt(floor.size())));
                }
                return mapFromGoal.map(PursuitOrder::search);
            }

            @Override
            public boolean sendsGoals() {
                return false;
            }
        };
    }
}
