package rsal.agent.team;

/// Allocations in which the agent that has the jobs divides them.
public final class CentralAllocations {
    private CentralAllocations() {}

    /// Contract net, as [Rules#DEFAULT] has it: a bid tells what each job would cost, also after each other, and the
    /// division is exact for up to eight jobs ([JobRoutes]).
    public static final class Bids implements AllocationType {
        @Override
        public String key() {
            return "bids";
        }

        @Override
        public String description() {
            return "The agent with the jobs divides them by bids of all path costs (contract net).";
        }
    }

    /// To compare with: [Rules#firstCome].
    public static final class FirstCome implements AllocationType {
        @Override
        public String key() {
            return "first";
        }

        @Override
        public String description() {
            return "A free robot gets the job that has waited longest.";
        }

        @Override
        public Rules rules(Rules usual) {
            return usual.firstCome();
        }
    }
}
