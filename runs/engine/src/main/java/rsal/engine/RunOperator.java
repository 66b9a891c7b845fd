package rsal.engine;

import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import rsal.agent.AgentType;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.engine.agent.OperatorMessages;
import rsal.engine.agent.TypedAgent;
import rsal.engine.report.Answer;
import rsal.engine.report.OperatorMessage;
import rsal.engine.report.PlacedThing;
import rsal.system.BridgeProvider;
import rsal.system.CommandTimeout;

/// What people tell a run to do. Each command is carried out on the run's thread between two steps, changes
/// what happens in the run, and is an event of it. Any thread may call; a stage completes on the run's
/// thread. A command that can't be carried out, or comes after the end, is answered by [Answer.Refused].
public final class RunOperator {
    private final RunLoop loop;

    RunOperator(RunLoop loop) {
        this.loop = loop;
    }

    /// Puts a robot somewhere: in the simulated world, if there is one, and in its localizer's belief. Or a
    /// thing of the simulated world.
    public CompletionStage<Answer> place(String entity, Pose2d mapFromEntity) {
        return loop.ask(run -> run.world().place(entity, mapFromEntity));
    }

    /// Tells a robot's localizer where it is. The robot stays where it truly is, which its localizer may find
    /// out.
    public CompletionStage<Answer> believe(String robot, Pose2d mapFromBase) {
        return loop.ask(run -> run.world().believe(robot, mapFromBase));
    }

    /// Puts something new into the simulated world.
    ///
    /// @return [Answer.Added] when it is there
    public CompletionStage<Answer> add(PlacedThing prop, Pose2d mapFromThing) {
        return loop.ask(run -> run.world().add(prop, mapFromThing));
    }

    /// Puts another robot into the simulated world, with devices and agents like those of one that is or was
    /// there.
    ///
    /// @return [Answer.Added] when it is there
    public CompletionStage<Answer> addRobot(String like, Pose2d mapFromBase) {
        return loop.ask(run -> run.world().addRobot(like, mapFromBase));
    }

    /// Puts a robot of one of the models that come with the program into the simulated world. It is named
    /// after its model, and has no agents.
    ///
    /// @return [Answer.Added] when it is there
    public CompletionStage<Answer> newRobot(String model, Pose2d mapFromBase) {
        return loop.ask(run -> run.world().newRobot(model, mapFromBase));
    }

    /// Takes a robot with its agents, or a thing, out of the simulated world.
    public CompletionStage<Answer> remove(String entity) {
        return loop.ask(run -> run.world().remove(entity));
    }

    /// Has a robot drive somewhere, by its agent if that can. Answers with [Answer.Sent].
    public CompletionStage<Answer> goTo(String robot, Pose2d mapFromGoal) {
        long now = loop.operatorTime();
        return loop.ask(run -> run.robotCommands().goTo(robot, mapFromGoal, now));
    }

    /// Gives a robot a behavior until its next command.
    ///
    /// @param behavior one of [rsal.behavior.Repertoire], `stand`, or empty to leave it to its agents again
    public CompletionStage<Answer> behave(String robot, String behavior) {
        long now = loop.operatorTime();
        return loop.ask(run -> run.robotCommands().behave(robot, behavior, now));
    }

    /// Drives a robot by hand, instead of its agents, until [#release]. Must be said again and again:
    /// the robot stands still when it was not for half a second of real time, and is given back after five.
    ///
    /// @param driver who that is; as long as one drives, no other can
    /// @param velocity wanted now; the base makes of it what it can
    public CompletionStage<Answer> drive(String robot, String driver, Twist2d velocity) {
        long now = loop.operatorTime();
        return loop.ask(run -> run.robotCommands().drive(robot, driver, velocity, now));
    }

    /// Gives a robot back to its agents that was driven by hand.
    public CompletionStage<Answer> release(String robot, String driver) {
        return loop.ask(run -> run.robotCommands().letGo(robot, driver));
    }

    /// Switches off all motors, until [#rearm].
    public CompletionStage<Answer> estop() {
        return loop.ask(run -> run.robotCommands().stop());
    }

    /// Ends the emergency stop. Who was switched off by [#stop(String)] stays off, and is named by
    /// [Answer.Armed].
    public CompletionStage<Answer> rearm() {
        return loop.ask(run -> run.robotCommands().rearm());
    }

    /// Switches the motors of one robot off, until [#rearm(String)].
    public CompletionStage<Answer> stop(String robot) {
        return loop.ask(run -> run.robotCommands().stop(robot, true));
    }

    /// Switches them on, also while those of the others stay off after an emergency stop.
    public CompletionStage<Answer> rearm(String robot) {
        return loop.ask(run -> run.robotCommands().stop(robot, false));
    }

    /// Starts another agent like one that is or was there, with its type and arguments.
    ///
    /// @param robot that it is to act for; empty when the other one has none
    /// @return [Answer.Added] when it runs
    public CompletionStage<Answer> addAgent(String like, String robot) {
        return loop.ask(run -> run.addAgent(like, robot));
    }

    /// Starts an agent again that has ended or failed.
    public CompletionStage<Answer> startAgent(String name) {
        return loop.ask(run -> run.startAgent(name));
    }

    /// Ends an agent, as it would at the end of the run.
    public CompletionStage<Answer> stopAgent(String name) {
        return loop.ask(run -> run.stopAgent(name));
    }

    /// Starts an agent of a type that is installed, as people want it. It is named after its type.
    ///
    /// @param robot id of the one that it is to act for; empty for none
    /// @param typed its arguments, as somebody typed them; those that are left out are as the type has them
    /// @return [Answer.Added] with its name
    public CompletionStage<Answer> newAgent(String type, String robot, Map<String, String> typed) {
        return loop.ask(run -> run.newAgent(type, robot, typed));
    }

    /// Says something to agents in the operator's name. The radio carries it as it does what agents without a
    /// robot say.
    ///
    /// @param to name of an agent; empty for all who listen
    /// @param topic name of one in [#sayable]
    /// @param typed what a person typed, by name of the field
    public CompletionStage<Answer> say(String to, String topic, Map<String, String> typed) {
        return loop.ask(run -> run.say(to, topic, typed));
    }

    /// Offers the robots to others, until the run ends, those that come later, too. Who has them over the
    /// bridge drives them like their agents: what people want comes first. Programs may also control the run,
    /// where the protocol can ([rsal.system.RunControl]).
    ///
    /// @param at where to listen: at this port, and those after it if need be; port 0 for any that are free
    /// @return [Answer.Bridged] when it is open
    public CompletionStage<Answer> bridge(BridgeProvider provider, InetSocketAddress at) {
        return bridge(provider, at, Optional.of(CommandTimeout.USUAL));
    }

    /// The same with another patience for clients.
    ///
    /// @param silence for how long robots are driven on when no command comes from a client any more, in real
    ///         time; empty for clients that command once
    public CompletionStage<Answer> bridge(BridgeProvider provider, InetSocketAddress at, Optional<Duration> silence) {
        return bridge(provider, at, silence, false);
    }

    /// The same where simulated time may wait for programs that follow it.
    ///
    /// @param isPaced whether it waits, and goes no faster than real time before one follows
    public CompletionStage<Answer> bridge(
            BridgeProvider provider, InetSocketAddress at, Optional<Duration> silence, boolean isPaced) {
        var timeout = new CommandTimeout(silence, loop::operatorTime);
        return loop.ask(run ->
                run.bridge(provider, at, timeout, new BridgeControl(loop, run.world(), provider.key()), isPaced));
    }

    /// Types of agents that people can start: the same in all runs.
    ///
    /// @throws rsal.settings.InvalidSettings when one of them can't be loaded
    public static List<AgentType> agentTypes() {
        return List.copyOf(TypedAgent.types().values());
    }

    /// What people can say: the same in all runs.
    public static List<OperatorMessage> sayable() {
        return OperatorMessages.ALL;
    }
}
