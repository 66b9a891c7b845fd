package rsal.cli;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tools.jackson.databind.JsonNode;

/// What an operator does with a run that has a page, without looking at that. The same person must have started it.
final class OperatorCommands {
    private OperatorCommands() {}

    /// `rsal status`
    @Command(name = "status", description = "Show how a run with a page gets on: its robots, and where they are.")
    static final class Status extends PageCommand {
        @Override
        int run() throws InterruptedException {
            JsonNode status = ask("/api/status");
            if (json) {
                printJson(status);
            } else {
                out().print(text(status));
                out().flush();
            }
            return Exit.SUCCESS;
        }

        private static String text(JsonNode status) {
            String outcome = status.path("outcome").asString("");
            String state = !outcome.isEmpty()
                    ? "over: " + outcome
                    : status.path("paused").asBoolean() ? "paused" : "runs";
            String motors = status.path("stopped").asBoolean() ? ", motors are off" : "";
            var robots = new Table("  ");
            status.path("robots").forEach(robot -> robots.row(row(robot)));
            return String.format(
                    Locale.ROOT,
                    "%s:%s, seed %s: %s at %.1f s%s%n%s",
                    status.path("scenario").asString(),
                    status.path("configuration").asString(),
                    status.path("seed").asString(),
                    state,
                    status.path("time").asDouble(),
                    motors,
                    robots.isEmpty() ? "  no robots\n" : robots);
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

    /// What is refused while somebody else has control.
    abstract static class Controlled extends PageCommand {
        @Option(
                names = "--take-control",
                description =
                        "Take control over from whoever has it in the page, who is told; it is given back at once.")
        private boolean takesControl;

        final JsonNode command(String command, Object message) throws InterruptedException {
            if (!takesControl || !isControlled()) { // where nobody has it, all may act
                return tell(command, message);
            }
            takeControl();
            return andThen(() -> tell(command, message), this::giveControlBack);
        }

        interface Work<T> {
            T done() throws InterruptedException;
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
    @Command(name = "stop", description = "End a run that has a page; the page stays.")
    static final class Stop extends Controlled {
        @Override
        int run() throws InterruptedException {
            command("stop", Map.of());
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
                "Emergency stop: switch off the motors of all robots of a run with a page, or of one alone.",
                "It is taken whoever has control."
            })
    static final class EmergencyStop extends PageCommand {
        @Parameters(paramLabel = "ROBOT", arity = "0..1", description = "Only this one's.")
        private Optional<String> robot = Optional.empty();

        @Override
        int run() throws InterruptedException {
            if (robot.isPresent()) {
                tellAtOnce("motors", motors(robot.get(), false));
            } else {
                tellAtOnce("estop", Map.of());
            }
            return Exit.SUCCESS;
        }
    }

    /// `rsal arm`
    @Command(
            name = "arm",
            description = {
                "Switch the motors on again: of all robots, or of one alone.",
                "A robot that was switched off alone stays off until it is named; such are printed."
            })
    static final class Arm extends Controlled {
        @Parameters(paramLabel = "ROBOT", arity = "0..1", description = "Only this one's.")
        private Optional<String> robot = Optional.empty();

        @Override
        int run() throws InterruptedException {
            if (robot.isPresent()) {
                command("motors", motors(robot.get(), true));
            } else {
                JsonNode off = command("rearm", Map.of()).path("off");
                if (!json && !off.isEmpty()) {
                    out().println(stayOff(
                            off.valueStream().map(JsonNode::asString).toList()));
                    out().flush();
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
        @Parameters(index = "0", paramLabel = "ROBOT", description = "As the page lists it.")
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
                description = "Heading, from x to y [°]; ${DEFAULT-VALUE} when left out.")
        private double degrees;

        final void commandPose(String command) throws InterruptedException {
            check(
                    Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(degrees),
                    "A pose must be finite, not (%s, %s, %s°).".formatted(x, y, degrees));
            command(command, Map.of("robot", robot, "x", x, "y", y, "heading", Math.toRadians(degrees)));
        }
    }

    /// `rsal goal`
    @Command(name = "goal", description = "Send a robot of a run with a page somewhere.")
    static final class Goal extends OfPose {
        @Override
        int run() throws InterruptedException {
            commandPose("goal");
            return Exit.SUCCESS;
        }
    }

    /// `rsal pose`
    @Command(
            name = "pose",
            description =
                    "Say where a robot of a run with a page is: a simulated one is put there, and localizers are told.")
    static final class Pose extends OfPose {
        @Override
        int run() throws InterruptedException {
            commandPose("place");
            return Exit.SUCCESS;
        }
    }
}
