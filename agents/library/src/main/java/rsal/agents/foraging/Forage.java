package rsal.agents.foraging;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.charging.Recharging;
import rsal.agents.exploration.Viewpoints;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Pilot;
import rsal.device.BlobFinder;
import rsal.device.Gripper;
import rsal.device.Navigator;
import rsal.device.PlaceFinder;
import rsal.settings.Arguments;

/// A forager: looks for things, brings what it finds to its depot, and monitors its battery, all by itself. What to
/// compare a team with.
public final class Forage extends AgentTypeBase {
    public Forage() {
        super(
                "forage",
                "Searches for things, brings them to its depot one by one, and recharges. It works without other"
                        + " agents.",
                List.of(
                        Explore.COLOR,
                        Explore.RANGE,
                        Viewpoints.COUNT,
                        Collecting.DEPOT,
                        Collecting.DEPOT_RADIUS,
                        Recharging.CHARGERS,
                        Recharging.LOW,
                        Recharging.FULL,
                        PoseReporter.PERIOD),
                List.of(Navigator.class, Gripper.class, BlobFinder.class, Pilot.class, PlaceFinder.class));
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Forager(self, RequiredRobot.of(self), arguments).begin();
    }
}
