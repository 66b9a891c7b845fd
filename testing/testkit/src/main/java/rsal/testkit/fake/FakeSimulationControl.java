package rsal.testkit.fake;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.SimulationControl;

/// The truth about the fake robots.
public final class FakeSimulationControl extends DeviceCore implements SimulationControl {
    private final List<FakeDriveBase> bases;
    private final OccupancyGrid world;
    private final List<Contact> contacts = new ArrayList<>();

    FakeSimulationControl(List<FakeDriveBase> bases, OccupancyGrid world) {
        super(new DeviceInfo("", "simulation", "fake"));
        this.bases = bases;
        this.world = world;
    }

    @Override
    public List<String> entities() {
        return bases.stream().map(base -> base.info().robot()).toList();
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return base(entity).map(FakeDriveBase::mapFromBase);
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        Optional<FakeDriveBase> base = base(entity);
        if (base.isEmpty()) {
            return new Placement.Refused("Nothing is called (%s).".formatted(entity));
        }
        if (!world.isFree(mapFromEntity.x(), mapFromEntity.y())) {
            return new Placement.Refused("A wall is there.");
        }
        base.get().place(mapFromEntity);
        return new Placement.Placed();
    }

    @Override
    public List<Contact> contacts() {
        return List.copyOf(contacts);
    }

    void touched(Instant time, String robot) {
        contacts.add(new Contact(time, robot, "wall"));
    }

    private Optional<FakeDriveBase> base(String robot) {
        return bases.stream().filter(base -> base.info().robot().equals(robot)).findFirst();
    }
}
