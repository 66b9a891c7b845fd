package rsal.engine;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.engine.report.Answer;
import rsal.engine.report.PlacedThing;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// The commands that people give to runs.
public final class OperatorCommands {
    private static final double FARTHEST = 1e6; // m
    private static final double FASTEST = 100; // m/s, rad/s; bases keep limits of their own
    private static final int LONGEST_NAME = 64; // characters of a driver's

    private static final Parameter<String> ROBOT = Parameter.text("robot", "id of the robot");
    private static final Parameter<String> ENTITY = Parameter.text("robot", "id of the robot, or name of the thing");
    private static final Parameter<String> FOR_ROBOT =
            Parameter.text("robot", "", "id of the robot that the agent acts for; empty for none");
    private static final Parameter<Double> X = length("x", "in the map frame");
    private static final Parameter<Double> Y = length("y", "in the map frame");
    private static final Parameter<Double> HEADING = Parameter.number(
                    "heading", 0, -Double.MAX_VALUE, Double.MAX_VALUE, "rad", "counter-clockwise from the map's x axis")
            .required();
    private static final Parameter<String> KIND = Parameter.choice(
                    "kind",
                    "",
                    Arrays.stream(PlacedThing.values()).map(Enum::name).toList(),
                    "what it is")
            .required();
    private static final Parameter<String> MODEL = Parameter.text("model", "name of the robot model");
    private static final Parameter<String> NAME = Parameter.text("name", "id of the robot, or name of the thing");
    private static final Parameter<String> AGENT = Parameter.text("name", "name of the agent");
    private static final Parameter<String> LIKE = Parameter.text("like", "name of the agent to copy");
    private static final Parameter<String> TYPE = Parameter.text("type", "key of the type of agents");
    private static final Parameter<Map<String, String>> ARGUMENTS =
            Parameter.texts("arguments", "parameters of the agent by name, as texts; others have their defaults");
    private static final Parameter<String> BEHAVIOR =
            Parameter.text("behavior", "", "name of the behavior; empty to give the robot back to its agents");
    private static final Parameter<String> DRIVER =
            Parameter.text("driver", "name of the person or program that drives, 1 to 64 characters");
    private static final Parameter<Double> VX = velocity("vx", "m/s", "forward");
    private static final Parameter<Double> VY = velocity("vy", "m/s", "to the left");
    private static final Parameter<Double> OMEGA = velocity("omega", "rad/s", "counter-clockwise");
    private static final Parameter<Boolean> ON = Parameter.flag("on", false, "true to switch the motors on");
    private static final Parameter<String> TO =
            Parameter.text("to", "", "name of an agent; empty for all subscribers of the topic");
    private static final Parameter<String> TOPIC = Parameter.text("topic", "name of the topic");
    private static final Parameter<Map<String, String>> FIELDS =
            Parameter.texts("fields", "fields of the message by name, as texts");
    private static final Parameter<String> FACTOR =
            Parameter.text("factor", "simulated over real time, from 0.1 to 1000, or max");

    /// In the order in which people read them.
    public static final List<OperatorCommand> ALL = List.of(
            control("pause", "Pauses simulated time. A run in real time can't be paused.", LiveRun::pause),
            control("resume", "Resumes simulated time.", LiveRun::resume),
            control("step", "Runs one step while the run is paused.", LiveRun::step),
            command(
                    "speed",
                    "Sets the speed of simulated time.",
                    List.of(FACTOR),
                    Answer.Done.class,
                    (run, given) -> done(() -> run.speed(SpeedFactor.parse(given.get(FACTOR))))),
            control("stop", "Ends the run.", LiveRun::stop),
            command(
                    "goal",
                    "Sends a robot to a pose.",
                    List.of(ROBOT, X, Y, HEADING),
                    Answer.Sent.class,
                    (run, given) -> run.operator().goTo(given.get(ROBOT), pose(given))),
            command(
                    "behavior",
                    "Gives a robot a behavior until its next command.",
                    List.of(ROBOT, BEHAVIOR),
                    Answer.Done.class,
                    (run, given) -> run.operator().behave(given.get(ROBOT), given.get(BEHAVIOR))),
            command(
                    "drive",
                    "Drives a robot by hand. Repeat it ten times a second: after 0.5 s without a command, the robot"
                            + " stands still; after 5 s, it is given back to its agents.",
                    List.of(ROBOT, DRIVER, VX, VY, OMEGA),
                    Answer.Done.class,
                    (run, given) -> run.operator().drive(given.get(ROBOT), driver(given), velocity(given))),
            safe(
                    "release",
                    "Gives a robot that was driven by hand back to its agents.",
                    List.of(ROBOT, DRIVER),
                    Answer.Done.class,
                    _ -> true,
                    (run, given) -> run.operator().release(given.get(ROBOT), driver(given))),
            new OperatorCommand(
                    "estop",
                    "Switches off the motors of all robots, in all runs side by side.",
                    List.of(),
                    Answer.Stopped.class,
                    _ -> true,
                    true,
                    (run, _) -> run.operator().estop()),
            command(
                    "rearm",
                    "Switches the motors on after an emergency stop, except of robots that were switched off one by one.",
                    List.of(),
                    Answer.Armed.class,
                    (run, _) -> run.operator().rearm()),
            safe(
                    "motors",
                    "Switches the motors of one robot off or on.",
                    List.of(ROBOT, ON),
                    Answer.Done.class,
                    given -> !given.get(ON),
                    (run, given) -> given.get(ON)
                            ? run.operator().rearm(given.get(ROBOT))
                            : run.operator().stop(given.get(ROBOT))),
            command(
                    "place",
                    "Moves a robot, or a thing, in the simulated world. Its localizer gets the new pose.",
                    List.of(ENTITY, X, Y, HEADING),
                    Answer.Done.class,
                    (run, given) -> run.operator().place(given.get(ENTITY), pose(given))),
            command(
                    "believe",
                    "Sets the pose that a robot's localizer believes. The robot itself does not move.",
                    List.of(ROBOT, X, Y, HEADING),
                    Answer.Done.class,
                    (run, given) -> run.operator().believe(given.get(ROBOT), pose(given))),
            command(
                    "add",
                    "Adds a thing to the simulated world.",
                    List.of(KIND, X, Y, HEADING),
                    Answer.Added.class,
                    (run, given) -> run.operator().add(PlacedThing.valueOf(given.get(KIND)), pose(given))),
            command(
                    "add-robot",
                    "Adds a robot like another one, with devices and agents, to the simulated world.",
                    List.of(ROBOT, X, Y, HEADING),
                    Answer.Added.class,
                    (run, given) -> run.operator().addRobot(given.get(ROBOT), pose(given))),
            command(
                    "new-robot",
                    "Adds a robot of a model, without agents, to the simulated world.",
                    List.of(MODEL, X, Y, HEADING),
                    Answer.Added.class,
                    (run, given) -> run.operator().newRobot(given.get(MODEL), pose(given))),
            command(
                    "remove",
                    "Removes a robot with its agents, or a thing, from the simulated world.",
                    List.of(NAME),
                    Answer.Done.class,
                    (run, given) -> run.operator().remove(given.get(NAME))),
            command(
                    "new-agent",
                    "Starts an agent of a type that is installed.",
                    List.of(TYPE, FOR_ROBOT, ARGUMENTS),
                    Answer.Added.class,
                    (run, given) ->
                            run.operator().newAgent(given.get(TYPE), given.get(FOR_ROBOT), given.get(ARGUMENTS))),
            command(
                    "add-agent",
                    "Starts an agent like another one.",
                    List.of(LIKE, FOR_ROBOT),
                    Answer.Added.class,
                    (run, given) -> run.operator().addAgent(given.get(LIKE), given.get(FOR_ROBOT))),
            command(
                    "start-agent",
                    "Restarts an agent that has ended or failed.",
                    List.of(AGENT),
                    Answer.Done.class,
                    (run, given) -> run.operator().startAgent(given.get(AGENT))),
            command(
                    "stop-agent",
                    "Ends an agent.",
                    List.of(AGENT),
                    Answer.Done.class,
                    (run, given) -> run.operator().stopAgent(given.get(AGENT))),
            command(
                    "say",
                    "Sends a message to agents in the operator's name.",
                    List.of(TO, TOPIC, FIELDS),
                    Answer.Done.class,
                    (run, given) -> run.operator().say(given.get(TO), given.get(TOPIC), given.get(FIELDS))));

    private OperatorCommands() {}

    /// The command of a name.
    public static Optional<OperatorCommand> of(String name) {
        return ALL.stream().filter(command -> command.name().equals(name)).findFirst();
    }

    private static OperatorCommand command(
            String name,
            String description,
            List<Parameter<?>> parameters,
            Class<? extends Answer> answer,
            BiFunction<LiveRun, Arguments, CompletionStage<Answer>> execution) {
        return safe(name, description, parameters, answer, _ -> false, execution);
    }

    private static OperatorCommand safe(
            String name,
            String description,
            List<Parameter<?>> parameters,
            Class<? extends Answer> answer,
            Predicate<Arguments> isSafe,
            BiFunction<LiveRun, Arguments, CompletionStage<Answer>> execution) {
        return new OperatorCommand(name, description, parameters, answer, isSafe, false, execution);
    }

    /// Of the run itself. It is done between two steps, for which nobody waits.
    private static OperatorCommand control(String name, String description, Consumer<LiveRun> does) {
        return command(name, description, List.of(), Answer.Done.class, (run, _) -> done(() -> does.accept(run)));
    }

    private static CompletionStage<Answer> done(Runnable work) {
        work.run();
        return CompletableFuture.completedFuture(new Answer.Done());
    }

    private static Parameter<Double> length(String name, String description) {
        return Parameter.number(name, 0, -FARTHEST, FARTHEST, "m", description).required();
    }

    private static Parameter<Double> velocity(String name, String unit, String description) {
        return Parameter.number(name, 0, -FASTEST, FASTEST, unit, description);
    }

    private static Pose2d pose(Arguments given) {
        return new Pose2d(given.get(X), given.get(Y), given.get(HEADING));
    }

    private static Twist2d velocity(Arguments given) {
        return new Twist2d(given.get(VX), given.get(VY), given.get(OMEGA));
    }

    private static String driver(Arguments given) {
        String name = given.get(DRIVER);
        if (name.isBlank() || name.length() > LONGEST_NAME) {
            throw new IllegalArgumentException(
                    "'driver' must have 1 to %d characters, not %d.".formatted(LONGEST_NAME, name.length()));
        }
        return name;
    }
}
