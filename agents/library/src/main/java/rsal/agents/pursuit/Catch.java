package rsal.agents.pursuit;

import rsal.agent.team.Job;

/// Go for a prey until it has been caught.
///
/// @param prey id of its robot
/// @param number of those that are after it: 1 for the first
record Catch(String prey, int number) implements Job {
    @Override
    public String name() {
        return number == 1 ? "hunt " + prey : "hunt %s as no. %d".formatted(prey, number);
    }
}
