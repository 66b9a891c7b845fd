package rsal.agents;

import rsal.agent.team.Job;

/// Go for a prey until it has been caught.
///
/// @param prey id of its robot
/// @param fromBehind whether to go where it is; else to cut it off on its other side
record Catch(String prey, boolean fromBehind) implements Job {
    @Override
    public String name() {
        return (fromBehind ? "hunt " : "cut off ") + prey;
    }
}
