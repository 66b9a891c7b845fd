package rsal.agents;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.agents.parts.AgentWords;
import rsal.data.PlaceObjective;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.PlaceFinder;

/// Notes each question and finds what the test says.
public final class FakePlaces extends DeviceCore implements PlaceFinder {
    public final List<String> asked = new ArrayList<>();
    public Result result = new Result.None("Nobody said where.");

    public FakePlaces(String robot) {
        super(new DeviceInfo(robot, "places", "fake"));
    }

    @Override
    public CompletionStage<Result> find(Pose2d mapFromStart, int count, double clearance, PlaceObjective objective) {
        String what = "%d from %s, %s".formatted(count, AgentWords.place(mapFromStart), AgentWords.distance(clearance));
        asked.add(objective == PlaceObjective.EVENLY ? what : what + ", " + objective.key());
        return CompletableFuture.completedFuture(result);
    }
}
