package rsal.cli.page;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.TextTable;
import rsal.cli.terminal.Unreachable;
import rsal.scenario.text.Counted;
import rsal.time.AllowedToReadWallClock;
import tools.jackson.databind.JsonNode;

/// What an operator does with a run that has a page, without looking at that. The same person must have started it.
@AllowedToReadWallClock("Says how fast a command was confirmed, and waits for what it leads to.")
public final class ControlCommands {
    private static final long LOOK_MILLIS = 200; // between two looks at what is waited for
    private static final int LOOKS = 50;

    private ControlCommands() {}

    /// `rsal status`
    @Command(
            name = "status",
            description =
                    "Show the state of a run with a page: its robots with their poses, and its agents with what they do.")
    public static final class Status extends PageCommand {
        @Override
        protected int run() throws InterruptedException {
            JsonNode status = ask("/api/status");
            if (json) {
                printJson(status);
            } else {
                out().print(text(status));
                out().flush();
            }
            return Exit.SUCCESS;
        }

        static String text(JsonNode status) {
            String outcome = status.path("outcome").asString("");
            String state = !outcome.isEmpty()
                    ? "over: " + outcome
                    : status.path("paused").asBoolean() ? "paused" : "runs";
            String motors = status.path("stopped").asBoolean() ? ", motors are off" : "";
            var robots = new TextTable("  ");
            status.path("robots").forEach(robot -> robots.row(row(robot)));
            var agents = new TextTable("  ");
            status.path("agents").forEach(agent -> agents.row(agentRow(agent)));
            var goals = new StringBuilder();
            status.path("goals").forEach(goal -> {
                if (SentTo.of(goal).isInProgress()) {
                    goals.append("  ").append(SentTo.of(goal)).append(System.lineSeparator());
                }
            });
            return String.format(
                    Locale.ROOT,
                    "%s:%s, seed %s: %s at %.1f s%s%nRobots%n%sAgents%n%s%s",
                    status.path("scenario").asString(),
                    status.path("configuration").asString(),
                    status.path("seed").asString(),
                    state,
                    status.path("time").asDouble(),
                    motors,
                    robots.isEmpty() ? "  none\n" : robots,
                    agents.isEmpty() ? "  none\n" : agents,
                    goals.isEmpty() ? "" : "Goals that people sent\n" + goals);
        }

        private static String[] agentRow(JsonNode agent) {
            String status = agent.path("status").asString().toLowerCase(Locale.ROOT);
            String state = ShownMind.words(agent.path("state"));
            return new String[] {
                agent.path("name").asString(),
                status.equals("running") ? state : state.isEmpty() ? status : status + ": " + state,
            };
        }

        private static String[] row(JsonNode robot) {
            return new String[] {
                robot.path("id").asString(),
                robot.path("x").isNumber()
                        ? String.format(
                                Locale.ROOT,
                                "(%.2f, %.2f, %.0f°)",
                                robot.path("x").asDouble(),
                                robot.path("y").asDouble(),
                                Math.toDegrees(robot.path("heading").asDouble()))
                        : "somewhere",
                robot.path("gone").asBoolean()
                        ? "gone"
                        : robot.path("stopped").asBoolean()
                                ? "motors off"
                                : robot.path("inCharge").asString(),
            };
        }
    }

    /// What changes something, and says what became of it and how fast.
    abstract static class Confirmed extends PageCommand {
        private long began;

        /// Does it, and measures how long that takes.
        final JsonNode timed(Work<JsonNode> work) throws InterruptedException {
            began = System.nanoTime();
            return work.done();
        }

        final double seconds() {
            return (System.nanoTime() - began) / 1e9;
        }

        /// @param said for people; `%s` is how fast
        /// @param result for programs, in order
        final void confirm(String said, Map<String, Object> result) {
            double seconds = seconds();
            if (json) {
                var all = new LinkedHashMap<String, Object>();
                all.put("command", spec.name());
                all.putAll(result);
                all.put("confirmedAfter", Math.round(seconds * 1000) / 1000.0);
                printJson(all);
            } else {
                out().println(said + String.format(Locale.ROOT, ", confirmed in %.1f s.", seconds));
                out().flush();
            }
        }

        final void say(String sentence) {
            if (!json) {
                out().println(sentence);
                out().flush();
            }
        }
    }

    interface Work<T> {
        T done() throws InterruptedException;
    }

    /// What is refused while somebody else has control.
    abstract static class Controlled extends Confirmed {
        @Option(
                names = "--take-control",
                description =
                        "Take over control from the person who has it in the page. The page reports this, and control"
                                + " is given back at once.")
        private boolean takesControl;

        final JsonNode command(String command, Object message) throws InterruptedException {
            if (!takesControl || !isControlled()) { // where nobody has it, all may act
                return timed(() -> send(command, message));
            }
            takeControl();
            return andThen(() -> timed(() -> send(command, message)), this::giveControlBack);
        }

        interface Ending {
            void done() throws InterruptedException;
        }

        /// Ends what was begun for some work, whatever came of that. Of two refusals that of the work is told.
        static <T> T andThen(Work<T> work, Ending ending) throws InterruptedException {
            T done;
            try {
                done = work.done();
            } catch (RuntimeException refused) {
                try {
                    ending.done();
                } catch (RuntimeException e) {
                    refused.addSuppressed(e);
                }
                throw refused;
            }
            ending.done();
            return done;
        }
    }

    /// `rsal stop`
    @Command(name = "stop", description = "End a run that has a page. The page stays.")
    public static final class Stop extends Controlled {
        @Override
        protected int run() throws InterruptedException {
            command("stop", Map.of());
            JsonNode status = ask("/api/status");
            for (int i = 0; i < LOOKS && status.path("outcome").asString("").isEmpty(); i++) {
                Thread.sleep(LOOK_MILLIS);
                status = ask("/api/status");
            }
            String outcome = status.path("outcome").asString("");
            double time = status.path("time").asDouble();
            confirm(
                    outcome.isEmpty()
                            ? "The run was asked to end and has not yet"
                            : String.format(Locale.ROOT, "The run has ended at %.1f s: %s", time, outcome),
                    Map.of("outcome", outcome, "time", time));
            return Exit.SUCCESS;
        }
    }

    private static Map<String, Object> motors(String robot, boolean on) {
        return Map.of("robot", robot, "on", on);
    }

    /// `rsal estop`
    @Command(
            name = "estop",
            description = {
                "Emergency stop: switch off the motors of all robots of a run with a page, or of one robot.",
                "It works for everyone, also while another person has control."
            })
    public static final class EmergencyStop extends Confirmed {
        @Parameters(paramLabel = "ROBOT", arity = "0..1", description = "Switch only the motors of this robot.")
        private Optional<String> robot = Optional.empty();

        @Override
        protected int run() throws InterruptedException {
            if (robot.isPresent()) {
                timed(() -> printAtOnce("motors", motors(robot.get(), false)));
                confirm("Motors of '%s' are off".formatted(robot.get()), Map.of("robot", robot.get()));
            } else {
                int robots = timed(() -> printAtOnce("estop", Map.of()))
                        .path("robots")
                        .asInt();
                confirm("Motors of %s are off".formatted(Counted.of(robots, "robot")), Map.of("robots", robots));
            }
            return Exit.SUCCESS;
        }
    }

    /// `rsal arm`
    @Command(
            name = "arm",
            description = {
                "Switch the motors of all robots, or of one robot, on again.",
                "A robot that was switched off alone stays off until you name it. The command prints such robots."
            })
    public static final class Arm extends Controlled {
        @Parameters(paramLabel = "ROBOT", arity = "0..1", description = "Switch only the motors of this robot.")
        private Optional<String> robot = Optional.empty();

        @Override
        protected int run() throws InterruptedException {
            if (robot.isPresent()) {
                command("motors", motors(robot.get(), true));
                confirm("Motors of '%s' are on".formatted(robot.get()), Map.of("robot", robot.get()));
            } else {
                JsonNode armed = command("rearm", Map.of());
                int on = armed.path("on").asInt();
                List<String> off =
                        armed.path("off").valueStream().map(JsonNode::asString).toList();
                confirm("Motors of %s are on".formatted(Counted.of(on, "robot")), Map.of("robots", on, "off", off));
                if (!off.isEmpty()) {
                    say(stayOff(off));
                }
            }
            return Exit.SUCCESS;
        }

        private static String stayOff(List<String> robots) {
            return "Motors that were switched off alone stay off: %s. Switch them on by 'rsal arm %s'."
                    .formatted(String.join(", ", robots), robots.size() == 1 ? robots.getFirst() : "ROBOT");
        }
    }

    /// What takes a robot and a pose.
    abstract static class OfPose extends Controlled {
        @Parameters(index = "0", paramLabel = "ROBOT", description = "Id of the robot, as the page lists it.")
        private String robot = "";

        @Parameters(index = "1", paramLabel = "X", description = "In the map's frame [m].")
        private double x;

        @Parameters(index = "2", paramLabel = "Y", description = "In the map's frame [m].")
        private double y;

        @Parameters(
                index = "3",
                paramLabel = "DEG",
                arity = "0..1",
                defaultValue = "0",
                description = "Heading, from x to y [°]. Default: ${DEFAULT-VALUE}.")
        private double degrees;

        final JsonNode commandPose(String command) throws InterruptedException {
            check(
                    Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(degrees),
                    "A pose must be finite, not (%s, %s, %s°).".formatted(x, y, degrees));
            return command(command, Map.of("robot", robot, "x", x, "y", y, "heading", Math.toRadians(degrees)));
        }

        final String robot() {
            return robot;
        }

        final String pose() {
            return String.format(Locale.ROOT, "(%.2f, %.2f, %.0f°)", x, y, degrees);
        }
    }

    /// `rsal goal`
    @Command(
            name = "goal",
            description = {
                "Send a robot of a run with a page to a goal.",
                "The goal has a number, by which 'rsal status --json' lists it."
            })
    public static final class Goal extends OfPose {
        @Option(
                names = "--wait",
                description = "Wait until the goal has ended, and print the result. The exit code is 0 if the robot has"
                        + " reached the goal, otherwise 4. Ctrl-C ends the waiting, not the goal.")
        private boolean waits;

        @Override
        protected int run() throws InterruptedException {
            int number = commandPose("goal").path("goal").asInt();
            String sent = "Goal %d: '%s' is sent to %s".formatted(number, robot(), pose());
            if (!waits) {
                confirm(sent, Map.of("goal", number, "robot", robot(), "status", "executing"));
                return Exit.SUCCESS;
            }
            if (!json) {
                confirm(sent, Map.of());
            }
            SentTo ended = await(number);
            if (json) {
                printJson(ended.json());
            } else {
                say(ended.toString());
            }
            return ended.succeeded() ? Exit.SUCCESS : Exit.NO_SUCCESS;
        }

        private SentTo await(int number) throws InterruptedException {
            while (true) {
                SentTo goal = ask("/api/status")
                        .path("goals")
                        .valueStream()
                        .map(SentTo::of)
                        .filter(each -> each.number() == number)
                        .findFirst()
                        .orElseThrow(() -> new Unreachable(
                                "Goal %d is not known any more: another run is there now, or it ended long ago."
                                        .formatted(number)));
                if (!goal.isInProgress()) {
                    return goal;
                }
                Thread.sleep(LOOK_MILLIS);
            }
        }
    }

    /// A goal as `/api/status` tells it.
    private record SentTo(JsonNode reported) {
        static SentTo of(JsonNode reported) {
            return new SentTo(reported);
        }

        int number() {
            return reported.path("id").asInt();
        }

        boolean isInProgress() {
            return status().equals("executing");
        }

        boolean succeeded() {
            return status().equals("succeeded");
        }

        private String status() {
            return reported.path("status").asString();
        }

        private double seconds() {
            return reported.path("ended").asDouble() - reported.path("sent").asDouble();
        }

        Map<String, Object> json() {
            return Map.of(
                    "command",
                    "goal",
                    "goal",
                    number(),
                    "robot",
                    reported.path("robot").asString(),
                    "status",
                    status(),
                    "why",
                    reported.path("why").asString(),
                    "seconds",
                    seconds());
        }

        /// `Goal 3 of 'robot-1' aborted after 12.0 s: A box is ahead.`
        @Override
        public String toString() {
            String why = reported.path("why").asString("");
            return isInProgress()
                    ? String.format(
                            Locale.ROOT,
                            "goal %d: '%s' drives to (%.2f, %.2f, %.0f°)",
                            number(),
                            reported.path("robot").asString(),
                            reported.path("x").asDouble(),
                            reported.path("y").asDouble(),
                            Math.toDegrees(reported.path("heading").asDouble()))
                    : String.format(
                            Locale.ROOT,
                            "Goal %d of '%s' %s after %.1f s%s",
                            number(),
                            reported.path("robot").asString(),
                            status(),
                            seconds(),
                            why.isEmpty() ? "." : ": " + why);
        }
    }

    /// `rsal pose`
    @Command(
            name = "pose",
            description =
                    "Set the pose of a robot in a run with a page: a simulated robot is moved there, and its localizer gets the pose.")
    public static final class Pose extends OfPose {
        @Override
        protected int run() throws InterruptedException {
            commandPose("place");
            confirm("'%s' is at %s".formatted(robot(), pose()), Map.of("robot", robot()));
            return Exit.SUCCESS;
        }
    }
}
