package rsal.agents.foraging;

import rsal.agent.team.Job;

/// To bring a thing to where such things belong.
record Fetch(CollectGoal goal) implements Job {
    @Override
    public String name() {
        return "fetch " + goal;
    }
}
