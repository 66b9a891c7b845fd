package rsal.agents;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.plain.PlainHostProvider;
import rsal.agent.platform.AgentPlatform;
import rsal.data.Pose2d;
import rsal.device.SimulationControl;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.time.LockstepScheduler;

/// The project's agents, with robots made of fakes, in simulated time. Keeps what they say.
public final class Scene {
    public final LockstepScheduler scheduler = new LockstepScheduler();
    public final List<Message<?>> said = new ArrayList<>();
    public final AgentPlatform platform;

    public Scene(Optional<SimulationControl> simulation) {
        var host = new PlainHostProvider().create(Arguments.defaults(List.of()), scheduler);
        platform = new AgentPlatform(scheduler, host, simulation);
        platform.onMessage(said::add);
    }

    public Scene() {
        this(Optional.empty());
    }

    public FakeRobot robot(String id, String role) {
        return new FakeRobot(id, role, scheduler);
    }

    /// Starts an agent of a type, named after its robot.
    public void start(String type, FakeRobot robot, Map<String, ?> arguments) {
        start(type, robot.robot.id(), Optional.of(robot.robot), arguments);
    }

    public void start(String type, String name, Optional<Robot> robot, Map<String, ?> arguments) {
        AgentType found = ServiceLoader.load(AgentType.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(candidate -> candidate.key().equals(type))
                .findFirst()
                .orElseThrow();
        platform.start(new AgentSpec(name, type, found, Arguments.of(found.parameters(), arguments), robot, 1));
        advance(0);
    }

    public void advance(double seconds) {
        scheduler.advance(Duration.ofMillis(Math.round(seconds * 1000)));
    }

    /// Somebody without an agent here says something, and it is heard.
    public <M> void hear(String sender, Topic<M> topic, M message) {
        platform.publish(sender, topic, message);
        advance(0);
    }

    public void report(String robot, String role, double x, double y) {
        hear("radio", PoseReport.TOPIC, new PoseReport(robot, role, new Pose2d(x, y, 0)));
    }

    public void order(String robot, double x, double y) {
        hear("operator", NewGoal.TOPIC, new NewGoal(robot, new Pose2d(x, y, 0)));
    }

    /// All that an agent has said on a topic.
    public <M> List<M> said(String sender, Topic<M> topic) {
        return said.stream()
                .filter(message ->
                        message.sender().equals(sender) && message.topic().equals(topic))
                .map(message -> topic.type().cast(message.content()))
                .toList();
    }

    public AgentPlatform.View view(String agent) {
        return platform.views().stream()
                .filter(view -> view.agent().name().equals(agent))
                .findFirst()
                .orElseThrow();
    }

    public String state(String agent) {
        return view(agent).state();
    }
}
