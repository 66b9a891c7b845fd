package rsal.agent.team;

import java.time.Duration;
import java.util.Optional;
import rsal.settings.PluginChoice;

/// How a team allots its jobs.
///
/// @param objective what is made least
/// @param inRoutes whether what comes after the next job is thought of: costs each member a way from each job to each
/// @param ping a member of which nothing was heard for that long is asked
/// @param silence after that long without a sign a member counts as silent; at least twice the ping
/// @param replyWithin how long a call for bids waits
/// @param reconsider how often jobs that are under way are allotted again, too, one each, as fits things that move;
/// 0 for never. Who has a job keeps it unless another can do it for clearly less.
/// @param tries after as many failures a job is given up; 0 for never
/// @param auction an [AllocationType] by which the members divide jobs among themselves; empty where the agent that
/// has the jobs divides them. Counts only in routes.
public record Rules(
        Objective objective,
        boolean inRoutes,
        Duration ping,
        Duration silence,
        Duration replyWithin,
        Duration reconsider,
        int tries,
        Optional<PluginChoice> auction) {
    public static final Rules DEFAULT = new Rules(
            Objective.LONGEST,
            true,
            Duration.ofSeconds(1),
            Duration.ofSeconds(5),
            Duration.ofSeconds(2),
            Duration.ZERO,
            5,
            Optional.empty());

    public Rules {
        if (objective == Objective.NONE && inRoutes) {
            throw new IllegalArgumentException("Routes are divided for an objective. Maybe oneAtATime().");
        }
    }

    public Rules withObjective(Objective other) {
        return new Rules(other, inRoutes, ping, silence, replyWithin, reconsider, tries, auction);
    }

    /// Who is free gets what has waited longest, whatever it costs.
    public Rules firstCome() {
        return oneAtATime().withObjective(Objective.NONE);
    }

    /// Only the next job of each counts.
    public Rules oneAtATime() {
        return new Rules(objective, false, ping, silence, replyWithin, reconsider, tries, auction);
    }

    public Rules withTries(int other) {
        return new Rules(objective, inRoutes, ping, silence, replyWithin, reconsider, other, auction);
    }

    /// As an [AllocationType] has it.
    public Rules allocated(PluginChoice allocation) {
        AllocationType type = allocation.as(AllocationType.class);
        Rules rules = type.rules(this);
        return new Rules(
                rules.objective,
                rules.inRoutes,
                rules.ping,
                rules.silence,
                type.isAmongMembers() ? AuctionRoom.TIME : rules.replyWithin,
                rules.reconsider,
                rules.tries,
                type.isAmongMembers() ? Optional.of(allocation) : Optional.empty());
    }

    /// Allots one job each, and all of them again so often.
    public Rules reconsideredEvery(Duration period) {
        return new Rules(objective, false, ping, silence, replyWithin, period, tries, auction);
    }
}
