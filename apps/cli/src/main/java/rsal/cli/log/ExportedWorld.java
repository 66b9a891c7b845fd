package rsal.cli.log;

import java.util.ArrayList;
import java.util.List;
import rsal.cli.show.ScenarioReference;
import rsal.data.Prism;
import rsal.device.SimulationControl.Marker;
import rsal.device.SimulationControl.Thing;
import rsal.scenario.PlannedThings;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.Surface;

/// What there is when a run begins, for programs that simulate it themselves.
final class ExportedWorld {
    private ExportedWorld() {}

    /// The world of a file, or that of a scenario with the things and robots that it puts there.
    ///
    /// @param named a world's file, or a scenario with or without a configuration
    static Scene of(String named, long seed) {
        ScenarioReference reference = ScenarioReference.parse(named);
        RunOptions options = RunOptions.NONE.withSeed(seed);
        RunPlan plan = reference
                .load()
                .plan(reference.configuration().map(options::withConfiguration).orElse(options));
        var things = new ArrayList<>(plan.scene().things());
        for (PlannedThings planned : plan.things()) {
            planned.each().forEach(each -> things.add(entity(each.thing())));
        }
        return plan.scene()
                .with(things, plan.robots().stream().map(PlannedRobot::spec).toList());
    }

    private static Entity entity(Thing thing) {
        List<Block> blocks = thing.body().pieces().stream()
                .map(piece -> new Block(piece, surface(piece, thing)))
                .toList();
        return new Entity(thing.name(), blocks, thing.mapFromThing(), 0, thing.givingPower());
    }

    private static Surface surface(Prism piece, Thing thing) {
        return new Surface(
                piece.color().orElse(thing.color()),
                thing.obstacle(),
                1,
                true,
                thing.marker().map(Marker::id).orElse(0),
                0,
                thing.grippable());
    }
}
