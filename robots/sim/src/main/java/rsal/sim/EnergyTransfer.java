package rsal.sim;

import java.util.List;
import rsal.sim.world.World;

/// Moves energy from those who give to those robots that touch them: first from things, then from other robots, in
/// the order in which they came or of their ids.
final class EnergyTransfer {
    private final SimulatedRobots team;
    private final Things things;

    EnergyTransfer(SimulatedRobots team, Things things) {
        this.team = team;
        this.things = things;
    }

    /// @param dt [s]
    void step(World world, double dt) {
        List<SimBattery> batteries = team.batteries();
        for (SimBattery battery : batteries) {
            for (Things.Item thing : things.givers()) {
                if (world.meets(battery.robot(), thing.body())) {
                    battery.take(thing.givingPower());
                }
            }
            for (SimBattery giver : batteries) {
                double most = giver.canGive();
                if (most > 0 && giver.robot() != battery.robot() && world.meets(battery.robot(), giver.robot())) {
                    giver.give(battery.take(most));
                }
            }
        }
        batteries.forEach(battery -> battery.settle(dt));
    }
}
