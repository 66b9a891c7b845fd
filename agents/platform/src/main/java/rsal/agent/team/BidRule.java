package rsal.agent.team;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/// What a member bids for one more job in its route, for which it has found the best position. The order of the
/// other jobs stays.
enum BidRule {
    /// The cost of the route with the job, so that the longest route is short: BidMaxPath.
    MINIMAX {
        @Override
        double of(double cost, double before) {
            return cost;
        }
    },
    /// What the job adds to the cost of the route, so that the sum of all routes is short: BidSumPath.
    MINISUM {
        @Override
        double of(double cost, double before) {
            return cost - before;
        }
    },
    /// The loss of value: each job is worth less the later it is done, so that jobs are done soon on average. The
    /// time-discounted reward of CBBA.
    DISCOUNTED {
        @Override
        double value(Estimate estimate, List<Integer> route, double discount) {
            double length = 0;
            double value = 0;
            for (int i = 0; i < route.size(); i++) {
                length += i == 0
                        ? estimate.first().get(route.getFirst())
                        : estimate.after().get(route.get(i - 1)).get(route.get(i));
                value += StrictMath.pow(discount, length);
            }
            return length == Double.POSITIVE_INFINITY ? length : -value;
        }

        @Override
        double of(double cost, double before) {
            return cost - before;
        }
    };

    /// @param cost of the route with the job
    /// @param before of the route without it
    abstract double of(double cost, double before);

    /// What a route costs by this rule.
    ///
    /// @param discount what is left of a job's value after a meter
    double value(Estimate estimate, List<Integer> route, double discount) {
        return JobRoutes.cost(estimate, route);
    }

    String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    static BidRule of(String word) {
        return Arrays.stream(values())
                .filter(rule -> rule.word().equals(word))
                .findFirst()
                .orElseThrow();
    }
}
