package rsal.agents;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.SimulationControl;

/// A world that holds names and poses, within 100 m of its origin.
final class FakeWorld extends DeviceCore implements SimulationControl {
    private static final double EDGE = 100; // m

    final Map<String, Pose2d> things = new LinkedHashMap<>();

    FakeWorld() {
        super(new DeviceInfo("", "simulation", "fake"));
    }

    @Override
    public List<String> entities() {
        return List.copyOf(things.keySet());
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return Optional.ofNullable(things.get(entity));
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        return things.replace(entity, mapFromEntity) == null
                ? new Placement.Refused("no such thing")
                : new Placement.Placed();
    }

    @Override
    public Placement add(Thing thing) {
        if (thing.mapFromThing().distanceTo(Pose2d.ORIGIN) > EDGE) {
            return new Placement.Refused("it is outside");
        }
        things.put(thing.name(), thing.mapFromThing());
        return new Placement.Placed();
    }

    @Override
    public List<Contact> contacts() {
        return List.of();
    }
}
