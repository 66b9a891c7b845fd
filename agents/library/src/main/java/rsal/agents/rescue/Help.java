package rsal.agents.rescue;

import rsal.agent.team.Job;
import rsal.data.Point2d;

/// Go to a victim and stay with it for a while.
///
/// @param victim what its marker says
/// @param mapFromVictim where somebody saw it; those that go there may know better by then
record Help(int victim, Point2d mapFromVictim) implements Job {
    @Override
    public String name() {
        return name(victim);
    }

    static String name(int victim) {
        return "help victim " + victim;
    }
}
