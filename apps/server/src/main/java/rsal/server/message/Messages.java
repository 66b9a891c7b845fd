package rsal.server.message;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/// What travels as JSON. The page's `api/messages.ts` is generated from these records. SI units and radians, as
/// everywhere; what is absent is `null`.
///
/// Longer than 500 lines, since it is a list: a record for each message.
public final class Messages {
    private Messages() {}

    /// What comes over the WebSocket beside frames: exactly one of these, the others are left out.
    @JsonInclude(JsonInclude.Include.NON_ABSENT)
    public record ServerMessage(
            Optional<RunInfo> run,
            Optional<Newcomers> newcomers,
            Optional<Things> things,
            Optional<Details> details,
            Optional<Events> events,
            Optional<Reach> reach,
            Optional<Access> access) {
        private static ServerMessage of(
                @Nullable RunInfo run,
                @Nullable Newcomers newcomers,
                @Nullable Things things,
                @Nullable Details details,
                @Nullable Events events,
                @Nullable Reach reach,
                @Nullable Access access) {
            return new ServerMessage(
                    Optional.ofNullable(run),
                    Optional.ofNullable(newcomers),
                    Optional.ofNullable(things),
                    Optional.ofNullable(details),
                    Optional.ofNullable(events),
                    Optional.ofNullable(reach),
                    Optional.ofNullable(access));
        }

        public static ServerMessage of(RunInfo run) {
            return of(run, null, null, null, null, null, null);
        }

        public static ServerMessage of(Newcomers newcomers) {
            return of(null, newcomers, null, null, null, null, null);
        }

        public static ServerMessage of(Things things) {
            return of(null, null, things, null, null, null, null);
        }

        public static ServerMessage of(Details details) {
            return of(null, null, null, details, null, null, null);
        }

        public static ServerMessage of(Events events) {
            return of(null, null, null, null, events, null, null);
        }

        public static ServerMessage of(Reach reach) {
            return of(null, null, null, null, null, reach, null);
        }

        public static ServerMessage of(Access access) {
            return of(null, null, null, null, null, null, access);
        }
    }

    /// What a viewer says over the WebSocket: the newest frame it has drawn, the newest event it has taken, and where
    /// it wants to look; and once, the token that it has.
    public record Receipt(
            Optional<Long> frame, Optional<Long> events, Optional<LookBack> look, Optional<String> token) {}

    /// What the token is worth that a viewer has shown.
    ///
    /// @param control whether it is this server's, so that the viewer may change something
    public record Access(boolean control) {}

    /// Looks back on a run, which itself goes on; or to the present again.
    ///
    /// @param live whether to see what is now, which a recording has not; then all else means nothing. Not when
    ///     left out
    /// @param time to be seen [s of the run]; left out, that which is seen
    /// @param step how many moments after that one; negative for before; 0 when left out
    /// @param playing whether to go on from there; not when left out
    /// @param speed 0.1 to 1000, or `max`; 1 when left out
    public record LookBack(
            Optional<Boolean> live,
            Optional<Double> time,
            Optional<Integer> step,
            Optional<Boolean> playing,
            Optional<String> speed) {
        /// This and then another one, in one.
        public LookBack then(LookBack next) {
            if (next.live.orElse(false) || next.time.isPresent()) {
                return next;
            }
            long steps = (long) step.orElse(0) + next.step.orElse(0);
            return new LookBack(
                    next.live,
                    live.orElse(false) ? Optional.of(Double.POSITIVE_INFINITY) : time, // from the newest on
                    Optional.of(Math.clamp(steps, Integer.MIN_VALUE, Integer.MAX_VALUE)),
                    next.playing,
                    next.speed);
        }
    }

    /// How far back one can look, and what those that do must know of the present nevertheless.
    ///
    /// @param from when the first moment was [s of the run]
    /// @param until when the newest was [s of the run]
    /// @param motors as they are now, wherever the viewer looks
    public record Reach(int run, double from, double until, MotorsOff motors) {}

    /// @param all whether no robot moves until all are armed
    /// @param of ids of robots whose motors are off, all of them then
    /// @param switchedOff those of them that were switched off one by one: they stay off when all are armed
    public record MotorsOff(boolean all, List<String> of, List<String> switchedOff) {
        public static final MotorsOff NONE = new MotorsOff(false, List.of(), List.of());
    }

    /// What stays the same during a run.
    ///
    /// @param number counts the runs of this server, from 1
    /// @param seed as text: numbers in browsers end at 2⁵³
    /// @param step length of a world step [s]
    /// @param robots in the order in which frames have them
    /// @param metrics that its ending will have
    /// @param mas key of the host that its agents were put on; empty for that of the scenario
    /// @param edited whether its scenario has another text than its file
    /// @param recording when it is none that goes on, but one that was recorded
    public record RunInfo(
            int number,
            String process,
            String scenario,
            String title,
            String description,
            String configuration,
            List<ConfigurationInfo> configurations,
            List<ArgumentInfo> arguments,
            String seed,
            double step,
            MapInfo map,
            List<RobotInfo> robots,
            List<MetricInfo> metrics,
            String mas,
            boolean edited,
            Optional<RecordingInfo> recording) {}

    /// Where a run is from that was recorded.
    ///
    /// @param name of the file
    /// @param started when it was run, in ISO 8601; empty when nobody knows
    /// @param whole whether the recording goes on to the run's end
    /// @param damage what is wrong with the file, a sentence each
    public record RecordingInfo(String name, String started, boolean whole, List<String> damage) {}

    /// @param realTime whether its runs go in real time, and can't be swept
    public record ConfigurationInfo(String name, String title, boolean realTime) {}

    /// @param value in this run, as one would type it
    /// @param typed whether somebody typed it; else it is the scenario's
    /// @param min least value of a number
    /// @param options what a text may be; empty when it may be anything
    public record ArgumentInfo(
            String name,
            ArgumentKind kind,
            String value,
            boolean typed,
            Optional<Double> min,
            Optional<Double> max,
            List<String> options,
            String unit,
            String description) {
        public enum ArgumentKind {
            NUMBER,
            INTEGER,
            TEXT,
            FLAG
        }
    }

    /// Cells are at `/api/map/<run>`, a byte each, row by row from the lower left one: 0 free, 100 a wall, 101 and
    /// more a wall of the first of the colors and so on, 255 unknown. Things don't count as walls.
    ///
    /// @param colors of walls, `#rrggbb`
    /// @param wallHeight how high the highest of them are above the floor [m]; absent where their world doesn't say
    /// @param resolution side of a cell [m]
    /// @param originX of the lower left corner, in the map frame [m]
    /// @param originY the same [m]
    public record MapInfo(
            String name,
            int width,
            int height,
            double resolution,
            double originX,
            double originY,
            List<String> colors,
            Optional<Double> wallHeight) {}

    /// @param color `#rrggbb`
    /// @param model for people: `Pioneer 2-DX`
    /// @param footprint corners in its base frame, x and y [m]
    /// @param pieces of its body, in its base frame, the lowest first; none when it looks like its footprint
    public record RobotInfo(
            String id,
            String role,
            String color,
            String model,
            List<List<Double>> footprint,
            List<PieceInfo> pieces,
            Optional<GripperInfo> gripper,
            Optional<LightInfo> light) {}

    /// Two paddles that close across, in the base frame [m, rad].
    ///
    /// @param name of the device
    /// @param x of the middle of gripper and paddles together, open along its own x axis
    /// @param length of gripper and paddles together
    /// @param width from outside to outside, when they are open
    /// @param low lower edge of the paddles above the floor, when they are not raised
    /// @param high the same, upper edge
    /// @param lift how far it can raise them
    public record GripperInfo(
            String name,
            double x,
            double y,
            double heading,
            double length,
            double width,
            double paddleLength,
            double paddleWidth,
            double low,
            double high,
            double lift) {}

    /// @param name of the device
    /// @param x in the base frame [m]
    /// @param color `#rrggbb`
    public record LightInfo(String name, double x, double y, String color) {}

    /// A piece of a body as seen from above.
    ///
    /// @param color `#rrggbb`; absent when it is the robot's own
    /// @param corners of its outline, x and y [m]; of a disc its middle alone
    /// @param radius of a disc [m]; 0 of an outline
    /// @param low its underside, above that of the body [m]
    /// @param high its top, the same [m]
    public record PieceInfo(
            Optional<String> color, List<List<Double>> corners, double radius, double low, double high) {}

    /// Robots that have joined the run. They come after all that were told before in the order of frames.
    public record Newcomers(int run, List<RobotInfo> robots) {}

    /// What of the simulated world is not a robot: changes to what was told before.
    ///
    /// @param gone numbers
    /// @param left how many more there are than can be told
    public record Things(int run, List<ThingInfo> came, List<Integer> gone, int left) {}

    /// A thing. It is here unless the frame says otherwise.
    ///
    /// @param number of no other thing of the run
    /// @param x in the map frame [m]
    /// @param heading [rad]
    /// @param height of its underside above the floor [m]
    /// @param pieces in its own frame, the lowest first
    public record ThingInfo(
            int number, String name, double x, double y, double heading, double height, List<PieceInfo> pieces) {}

    /// @param unit `m`, `s`; empty when it has none
    /// @param min the least value that is still right
    /// @param max the greatest value that is still right
    public record MetricInfo(String name, String unit, Optional<Double> min, Optional<Double> max) {}

    /// What changes now and then.
    ///
    /// @param whole whether these are all robots and agents; else those that are new or others than before
    /// @param ending once the run is over
    public record Details(
            int run, boolean whole, Optional<Ending> ending, List<RobotDetails> robots, List<AgentDetails> agents) {}

    /// @param outcome as in [rsal.engine.report.RunResult]; `broken` when the run itself failed
    /// @param metrics by name (`captureTime`; `distance.prey-1` of those per robot); `null` where there was
    ///         none
    /// @param outOfBounds names of the metrics that are worse than the scenario allows
    /// @param failed what went wrong with agents that ended by an error of their own, by name
    /// @param unhandledGoals goals for which agents had no plan at all, by name of the agent
    /// @param failure why it broke; else empty
    public record Ending(
            String outcome,
            double simulatedSeconds,
            double wallSeconds,
            String eventHash,
            Map<String, @Nullable Double> metrics,
            List<String> outOfBounds,
            Map<String, String> failed,
            Map<String, List<String>> unhandledGoals,
            String failure) {}

    /// @param gone whether a fault has taken it away: it can't be told anything
    /// @param goneFor for how long nobody has told where it is, when it is gone and anybody ever has [s]
    /// @param inCharge behavior that drives it, or its navigator; empty when neither does
    /// @param behavior what somebody told it to do, by the command `behavior`; empty when nobody did
    /// @param driver who drives it by keys; empty when nobody does
    /// @param quality how sure its localizer is: `localized`, `ambiguous`, `lost`; empty when nothing tells
    /// @param carried what its actuators have carried elsewhere
    /// @param real what there is to say of one that is not simulated
    /// @param maps that it has drawn itself so far, the one that is drawn first
    public record RobotDetails(
            String id,
            boolean gone,
            Optional<Double> goneFor,
            String inCharge,
            String behavior,
            String driver,
            boolean stopped,
            String quality,
            List<CarriedInfo> carried,
            Optional<RealDetails> real,
            List<DeviceDetails> devices,
            List<DrawnMap> maps) {}

    /// What stands on one actuator, which is not at home.
    ///
    /// @param devices by name
    /// @param pieces numbers of [RobotInfo#pieces], from 0; some may not have been told
    /// @param x where the base would be, in the base frame, if all of the robot had moved like that [m]
    /// @param heading the same [rad]
    /// @param rise the same, upwards [m]
    public record CarriedInfo(
            List<String> devices, List<Integer> pieces, double x, double y, double heading, double rise) {}

    /// What a robot's cameras make out.
    public record Cameras(List<CameraView> cameras) {}

    /// @param x where it is mounted, in the robot's base frame [m]
    /// @param y the same [m]
    /// @param heading the same, where it looks [rad]
    /// @param fieldOfView from its left edge to its right [rad]
    /// @param blobs from left to right; at most 100
    public record CameraView(
            String name, double x, double y, double heading, double fieldOfView, List<BlobInfo> blobs) {}

    /// A patch of one color.
    ///
    /// @param color `#rrggbb`
    /// @param from direction of its right edge in the camera's frame, counter-clockwise [rad]
    /// @param to of its left edge, the same
    /// @param range how far it is [m]; absent when the camera can't tell
    public record BlobInfo(String color, double from, double to, Optional<Double> range) {}

    /// Where devices of a robot are mounted, of those of which that is told.
    ///
    /// @param mounts several in a row of a device with several sensors
    public record Mounts(List<MountInfo> mounts) {}

    /// @param x in the robot's base frame [m]
    /// @param y the same [m]
    /// @param heading the same [rad]
    public record MountInfo(String device, double x, double y, double heading) {}

    /// @param proxy whether a stand-in of it is in the simulated world
    /// @param silence for how long nobody has told where it is, if that is longer than it should be [s]
    public record RealDetails(boolean proxy, Optional<Double> silence) {}

    /// Cells are at `/api/drawn/<run>?robot=<id>&device=<device>`, as those of [MapInfo], in which they lie row by
    /// row behind five little-endian numbers: width and height (integers of 4 bytes), side of a cell, origin x and
    /// y [m] (of 8 bytes). Robots that explore together draw the same.
    ///
    /// @param device that drew it; empty where that is not known
    /// @param time when it was drawn [s of the run]
    public record DrawnMap(String device, double time) {}

    /// @param reason why it is not well; else empty
    public record DeviceDetails(String name, String driver, String type, Condition health, String reason) {
        public enum Condition {
            OK,
            STALE,
            LOST
        }
    }

    /// @param robot id of its robot; empty when it has none
    /// @param state what it says it is doing
    /// @param lastSent when it sent the last of its messages [s of the run]; absent while it has sent none
    /// @param messages newest few that it sent, newest last
    public record AgentDetails(
            String name,
            String role,
            String type,
            String robot,
            Status status,
            String state,
            Map<String, String> beliefs,
            long sent,
            Optional<Double> lastSent,
            List<String> messages) {
        public enum Status {
            RUNNING,
            ENDED,
            FAILED
        }
    }

    public record Events(int run, List<EventInfo> events) {}

    /// @param sequence counts a run's events, from 1
    /// @param time simulated [s]
    /// @param said when it is a message of its subject's
    public record EventInfo(
            long sequence, double time, String kind, String subject, String text, Optional<SaidInfo> said) {}

    /// @param to name of an agent; empty for all who listen
    /// @param conversation its id; empty, as protocol and act then, when it belongs to none
    public record SaidInfo(String to, String topic, String conversation, String protocol, String act) {}

    /// How a run gets on.
    ///
    /// @param time simulated [s]
    /// @param stopped whether all motors are off
    /// @param outcome how it ended; empty while it goes on
    /// @param goals to which people sent robots, oldest first; of those that ended the last 200
    public record StatusInfo(
            int run,
            String scenario,
            String configuration,
            String seed,
            double time,
            boolean paused,
            boolean stopped,
            String outcome,
            List<RobotStatus> robots,
            List<AgentStatus> agents,
            List<SentGoalInfo> goals) {}

    /// @param robot id of its robot; empty when it has none
    /// @param state what it says it is doing; the failure's message when it failed
    public record AgentStatus(String name, String robot, AgentDetails.Status status, String state) {}

    /// A place to which somebody sent a robot.
    ///
    /// @param x in the map's frame [m]; y the same
    /// @param heading in the map's frame [rad]
    /// @param status `executing`, `succeeded`, `canceled` or `aborted`
    /// @param why it did not get there; empty otherwise
    /// @param sent when [simulated s]
    /// @param ended when [simulated s]; absent while it is under way
    public record SentGoalInfo(
            int id,
            String robot,
            double x,
            double y,
            double heading,
            String status,
            String why,
            double sent,
            Optional<Double> ended) {}

    /// Who has control: nobody else may change anything then, but for an emergency stop.
    ///
    /// @param holder its name; empty when nobody has, and all who have the token may
    /// @param mine whether it is the one that asks, by the header `RSAL-Operator`
    public record Control(Optional<String> holder, boolean mine) {}

    /// Takes control for 10 s, or keeps it for as long.
    ///
    /// @param name for people, at most 64 characters
    /// @param over whether also from somebody else
    public record ControlWish(String name, boolean over) {}

    /// @param most how many runs there may be at once
    /// @param runs the first, and those beside it in the order in which they came
    public record SideBySide(int most, List<SeatInfo> runs) {}

    /// One of the runs side by side, as it is now.
    ///
    /// @param number 1 of the first, which is at `/`; others are at `/beside/<number>/`. It stays when another
    ///         run begins there, and is never used again
    /// @param typed arguments that somebody typed, by name; all others are the scenario's
    /// @param mas as [RunInfo] has it
    /// @param time simulated [s]
    /// @param speed 0.1 to 1000, or `max`
    /// @param stopped whether all motors are off
    /// @param outcome how it ended; empty while it goes on
    public record SeatInfo(
            int number,
            String title,
            String scenario,
            String configuration,
            String seed,
            Map<String, String> typed,
            String mas,
            double time,
            String speed,
            boolean paused,
            boolean stopped,
            String outcome) {}

    /// @param x where it is, or believes to be, in the map frame [m]; empty when nobody knows
    /// @param heading [rad]
    public record RobotStatus(
            String id,
            String role,
            Optional<Double> x,
            Optional<Double> y,
            Optional<Double> heading,
            boolean gone,
            boolean stopped,
            String inCharge) {}

    /// What of a robot's devices can be plotted.
    ///
    /// @param time of the run [s]
    public record PlottedNumbers(double time, List<DeviceNumbers> devices) {}

    /// What a number has been so far, as densely as it was kept.
    ///
    /// @param times of the run, growing [s]
    /// @param values at these times, in its unit; empty when it was not finite then
    public record PastNumbers(List<Double> times, List<Optional<Double>> values) {}

    /// Where robots went in the 30 s before some moment.
    ///
    /// @param robots in the order of the run's
    public record Trails(List<Trail> robots) {}

    /// Where a robot went: points 5 cm apart, or more; none while nobody knew.
    ///
    /// @param times of the run, growing [s]
    /// @param xs in the map frame [m]
    /// @param ys the same
    /// @param driven whether it drove there from the point before; not where it was put there
    public record Trail(List<Double> times, List<Double> xs, List<Double> ys, List<Boolean> driven) {}

    public record DeviceNumbers(String device, List<NumberInfo> numbers) {}

    /// @param name of no other number of the device
    /// @param title for people; empty where the device's name says it all
    /// @param unit `m/s`, `°`; empty when it has none, or nobody knows
    /// @param value in that unit; empty when it is not finite now
    public record NumberInfo(String name, String title, String unit, Optional<Double> value) {}

    /// Motors are on again, all but those of some.
    ///
    /// @param on of how many robots
    /// @param off ids of robots whose motors were switched off one by one, and stay off
    public record Armed(int on, List<String> off) {}

    /// @param robots whose motors are off now
    public record Stopped(int robots) {}

    /// @param goal id of it
    public record Sent(int goal) {}

    /// What can be run.
    ///
    /// @param scenarios those that come with the program, and a person's own
    /// @param hosts what agents can run on
    public record Scenarios(List<ScenarioInfo> scenarios, List<HostInfo> hosts) {}

    /// @param id what [Restart] calls it
    /// @param problem why it can't be run; empty when it can
    public record ScenarioInfo(
            String id, String title, String description, List<ConfigurationInfo> configurations, String problem) {}

    /// @param realTime whether agents live in real time there, so that no run is like another
    public record HostInfo(String key, String description, boolean realTime) {}

    /// Asks for another run; what is left out stays as it is, or, of another scenario, is as that one says.
    ///
    /// @param scenario as [ScenarioInfo] has it; read again
    /// @param arguments as typed, by name; all others are the scenario's
    /// @param speed 0.1 to 1000, or `max`
    /// @param mas key of the agents' host; empty for the scenario's
    /// @param text stands for that of the scenario's file
    public record Restart(
            Optional<String> scenario,
            Optional<String> configuration,
            Optional<Map<String, String>> arguments,
            Optional<String> seed,
            Optional<String> speed,
            Optional<String> mas,
            Optional<String> text) {}

    /// What a scenario says, to be edited.
    ///
    /// @param scenario as [ScenarioInfo] has it; empty for that of the present run when it can't be chosen
    /// @param file what errors call it
    /// @param saved what its file holds now, when that is one which [TextToSave] may replace
    public record ScenarioText(String scenario, String file, String text, Optional<String> saved) {}

    /// Asks what is wrong with a text.
    ///
    /// @param scenario whose text it would be, as [ScenarioInfo] has it; left out: of the present run
    public record TextToCheck(Optional<String> scenario, String text) {}

    /// @param configurations of the text; none when it can't be read so far
    /// @param errors of all configurations, the first of many
    public record TextCheck(List<ConfigurationInfo> configurations, List<TextError> errors) {}

    /// @param file of [ScenarioText], or another that this names
    /// @param line from 1; 0 for the whole file
    /// @param column from 1
    /// @param remedy what to try; empty when nobody can tell
    public record TextError(String file, int line, int column, String message, String remedy) {}

    /// Asks for a scenario's file to be written again.
    ///
    /// @param scenario as [ScenarioInfo] has it
    /// @param before what the file must hold until then, so that nothing is lost that somebody else wrote
    public record TextToSave(String scenario, String before, String text) {}

    /// What another run would be, for the form.
    public record Plan(String seed, List<ArgumentInfo> arguments) {}

    /// Asks for a sweep: every configuration with every value of every argument, each with all seeds.
    ///
    /// @param scenario as [ScenarioInfo] has it; read again
    /// @param arguments as typed, by name: a value, or several as `1,2,4` or `1:10:3`; all others are the
    /// scenario's
    /// @param seeds how many, from 1, or a range like `101-130`
    /// @param limit simulated time after which runs end [s], as typed; empty when only the scenario says
    /// @param jobs how many runs at once; left out: as many as may be
    public record SweepWish(
            String scenario,
            List<String> configurations,
            Map<String, String> arguments,
            String seeds,
            String limit,
            Optional<Integer> jobs) {}

    /// What a sweep would be, for the form.
    public record SweepSize(int combinations, int seeds, long runs) {}

    /// @param possible whether sweeps can be begun here
    /// @param jobs how many runs there may be at once
    /// @param newest the one that was begun last here, whether it goes on or not
    public record SweepState(boolean possible, int jobs, Optional<SweepInfo> newest) {}

    /// @param runs of one combination that have ended, by number; the last 500
    public record SweepRuns(List<SweepRunInfo> runs) {}

    /// A run of a sweep.
    ///
    /// @param run its number in the sweep, from 1
    /// @param reason why it broke; else empty
    /// @param seconds simulated; absent when it broke
    public record SweepRunInfo(int run, String seed, String outcome, String reason, Optional<Double> seconds) {}

    /// To see a run of a sweep again: it comes out as it did.
    ///
    /// @param sweep its number, as in [SweepInfo]
    /// @param run its number in the sweep, from 1
    public record SweepRunAgain(int sweep, int run) {}

    /// A sweep as it is now.
    ///
    /// @param number counts this server's sweeps, from 1
    /// @param problem why it failed; empty when it did not
    /// @param command what does the same in a terminal
    /// @param folder where its rows are
    /// @param jobs how many runs at once
    /// @param runs how many there will be
    /// @param ended how many of them have ended
    /// @param broken how many of those could not go on, or not begin
    /// @param left until all have ended, at the pace so far [s]; absent while nobody can tell
    public record SweepInfo(
            int number,
            String scenario,
            String title,
            SweepStatus status,
            String problem,
            String command,
            String folder,
            int jobs,
            int runs,
            int ended,
            int broken,
            Optional<Double> left,
            List<SweepMetric> metrics,
            List<SweepCombination> combinations) {
        public enum SweepStatus {
            RUNS,
            ENDED,
            STOPPED,
            FAILED
        }
    }

    /// @param unit empty when it has none
    /// @param horizon up to when times of events count; absent of other metrics, and before a run has ended
    public record SweepMetric(String name, String unit, Optional<Double> horizon) {}

    /// The result of a combination so far.
    ///
    /// @param label what it is called among the others
    /// @param ended how many of its runs have
    /// @param outcomes that occurred in the sweep; the same for all combinations
    /// @param metrics by name; without those of which nothing was measured
    public record SweepCombination(
            String label, int ended, List<OutcomeShare> outcomes, Map<String, SweepEstimate> metrics) {}

    /// Of the runs of a combination.
    ///
    /// @param low end of the 95 % confidence interval of the share; absent while no run has ended
    public record OutcomeShare(String outcome, int count, Optional<Double> low, Optional<Double> high) {}

    /// @param count of how many runs
    /// @param measured in how many of them there was something to measure; fewer where the others count to the
    /// horizon
    /// @param low end of the 95 % confidence interval of the mean; absent of one run
    public record SweepEstimate(
            int count, int measured, double mean, Optional<Double> low, Optional<Double> high, Box box) {}

    /// Sweeps that were there before the newest; the 50 that changed last.
    public record SweepsBefore(List<EarlierSweep> sweeps) {}

    /// @param name of its folder
    /// @param started when it was begun, or last gone on with; ISO 8601, UTC
    /// @param command what it was begun, or gone on with in a terminal
    public record EarlierSweep(String name, String title, String started, long runs, long ended, String command) {}

    /// As in a box plot.
    ///
    /// @param low where the lower whisker ends
    /// @param first quartile
    /// @param high where the upper whisker ends
    /// @param outside values beyond the whiskers
    public record Box(double low, double first, double median, double third, double high, List<Double> outside) {}

    /// What a robot can be told to do.
    ///
    /// @param forward fastest [m/s]
    /// @param backward fastest [m/s]
    /// @param sideways fastest to the left [m/s]; 0 when it can't
    /// @param turn fastest counter-clockwise [rad/s]
    /// @param behaviors for the command `behavior`; those that need no sensors are there for all
    /// @param noBehavior why it can't be given others; empty when it can
    /// @param noGoal why it can't be sent anywhere; empty when it can
    public record Abilities(
            double forward,
            double backward,
            double sideways,
            double turn,
            List<String> behaviors,
            String noBehavior,
            String noGoal) {}

    /// What the devices of a robot have told last.
    public record Readings(List<ReadingInfo> readings) {}

    /// @param device its name within the robot
    /// @param facts in words; only the first few of something that can be many
    /// @param left how many more there are
    /// @param age how long ago it was taken [s], by the run's clock; below zero when a robot's clock is ahead
    /// @param image of a camera, made smaller
    public record ReadingInfo(String device, List<Fact> facts, int left, double age, Optional<ImageInfo> image) {}

    /// @param rgb red, green and blue of each pixel, row by row from the top, in Base64
    public record ImageInfo(int width, int height, String rgb) {}

    /// @param value for people to read
    /// @param color that it is about, `#rrggbb`
    public record Fact(String name, String value, Optional<String> color) {}

    /// Who heard what so far in a run that limits communication; else nothing. Of more than 10,000 pairs the sums
    /// only.
    public record Communication(List<HearingInfo> communication) {}

    /// Which robots' agents hear each other. Where nothing limits that, all do, and those are told that spoke.
    ///
    /// @param ofChosen whether there are so many robots that only links of the one asked for are told;
    /// and of what has been, none
    public record Links(List<LinkInfo> links, boolean ofChosen) {}

    /// @param one id of a robot
    /// @param other the same
    /// @param there whether agents of the other would hear, but for chance, what those of the one say
    /// @param back the other way
    /// @param saidThere whether they heard something within the last second
    /// @param saidBack the other way
    public record LinkInfo(
            String one, String other, boolean there, boolean back, boolean saidThere, boolean saidBack) {}

    /// What people can say to agents: the same in all runs.
    public record Sayables(List<SayableInfo> sayable) {}

    /// @param topic on which it is said
    public record SayableInfo(String topic, List<FieldInfo> fields) {}

    /// @param choices all that may be written there; empty where that is not limited
    public record FieldInfo(String name, FieldKind kind, List<String> choices) {}

    /// What is written in a field: places as `x y` [m], several of them as `x y; x y`, poses as `x y heading` [m, °].
    public enum FieldKind {
        WORDS,
        NUMBER,
        CHOICE,
        PLACE,
        PLACES,
        POSE
    }

    /// What was said so far, by topic.
    public record Topics(List<TopicInfo> topics) {}

    /// @param topic `…` for all together of which there were too many to count each
    /// @param said how many messages
    /// @param heard how often one of them reached an agent that listened
    /// @param outOfRange how often one did not, as it was too far away or behind a wall
    /// @param byChance how often one did not by chance
    /// @param crowded how often one did not as its sender had more to say than the bandwidth allows
    /// @param byFault how often one did not because of a fault
    public record TopicInfo(
            String topic, long said, long heard, long outOfRange, long byChance, long crowded, long byFault) {}

    /// What agents say so often that it is no event each time, as where they are.
    ///
    /// @param topics of which there is some
    /// @param said the newest of the topic that was asked for, oldest first
    public record Routine(List<String> topics, List<RoutineInfo> said) {}

    /// @param time simulated [s]
    public record RoutineInfo(double time, String from, String text, SaidInfo said) {}

    /// An agent, looked into.
    ///
    /// @param arguments all that its type takes, in the order in which that declares them
    /// @param status how it is; absent when it has not started
    /// @param state what it says it is doing; why it failed when it has
    /// @param shown what it shows of itself, which those do, too, that have no mind
    /// @param mind what it believes and wants, when it has a mind and runs
    /// @param history what changed lately in what it does, believes and wants, oldest first: at most 16 changes of
    /// each of at most 64 beliefs and goals. Of these only what changed while somebody asked about it
    /// @param mail what reached it lately, oldest first: at most 8 messages of each of at most 32 topics; absent
    /// where that is not known
    /// @param talks what it and its partners said in conversations lately, oldest first; at most 100
    /// @param hearings what it heard of others and others of it, where that is recorded; at most 60
    public record AgentInside(
            String agent,
            List<SettingInfo> arguments,
            Optional<AgentDetails.Status> status,
            String state,
            List<BeliefInfo> shown,
            Optional<MindInfo> mind,
            Optional<ProgramInfo> program,
            List<ChangeInfo> history,
            Optional<List<MailInfo>> mail,
            List<TalkInfo> talks,
            List<HearingInfo> hearings) {}

    /// An argument that an agent was started with.
    ///
    /// @param value as one would type it
    /// @param fallback the same, when none is given; absent where one must be
    public record SettingInfo(String name, String value, Optional<String> fallback, String unit, String description) {}

    /// @param left how many beliefs and goals there are besides
    public record MindInfo(List<BeliefInfo> beliefs, List<GoalInfo> goals, int left) {}

    /// What an agent goes by that is written in AgentSpeak.
    ///
    /// @param rules as they are written
    /// @param left how many rules and plans there are besides
    public record ProgramInfo(List<String> rules, List<PlanInfo> plans, int left) {}

    /// @param name as [GoalInfo] has it: its label, or the file and the line where it begins
    /// @param text as it is written
    public record PlanInfo(String name, String text) {}

    /// @param time since the run's start [s]
    /// @param name of the belief or goal; empty of what it does
    /// @param words what it is from then on; empty when there is none any more
    public record ChangeInfo(double time, Kind kind, String name, String words) {
        public enum Kind {
            DOES,
            BELIEVES,
            WANTS
        }
    }

    public record BeliefInfo(String name, String value) {}

    /// @param urgency a number, larger for what is more urgent
    /// @param plans the ways to reach it, in the order in which they are tried
    /// @param steps what is done for it, from the goal inward: `collect: fetch`
    /// @param failure which plan failed last, and why; empty when none has
    public record GoalInfo(
            String name, Wanted state, String urgency, List<String> plans, List<String> steps, String failure) {}

    public enum Wanted {
        NOT_WANTED,
        REACHED,
        WAITING,
        PURSUED,
        SUSPENDED,
        RESTING
    }

    /// A message that reached an agent.
    ///
    /// @param time since the run's start, when it was said [s]
    /// @param from name of the agent that said it, or `operator`
    /// @param forAll whether it was for all who listen, else for this agent alone
    public record MailInfo(double time, String from, boolean forAll, String topic, String words) {}

    /// An act of a conversation.
    ///
    /// @param time since the run's start [s]
    /// @param from name of the agent that said it
    /// @param to name of the agent that it was for
    /// @param protocol `fipa-request`
    /// @param act `inform`
    /// @param times how often it was said until it was heard
    public record TalkInfo(
            double time,
            String from,
            String to,
            String conversation,
            String protocol,
            String act,
            String words,
            int times) {}

    /// @param sender empty for all together
    /// @param listener empty for all together
    /// @param heard messages of the sender that reached the listener
    /// @param lost messages that the listener listened to and that did not get through
    public record HearingInfo(String sender, String listener, String topic, long heard, long lost) {}

    /// Models of robots that the command `new-robot` can name.
    public record RobotModels(List<RobotModelInfo> models) {}

    /// @param model `pioneer2dx`
    /// @param title for people: `Pioneer 2-DX`
    public record RobotModelInfo(String model, String title) {}

    /// @param name that what was added has
    public record Added(String name) {}

    /// Types of agents that are installed.
    public record AgentTypes(List<AgentTypeInfo> types) {}

    /// @param needsRobot whether it can't be without one
    /// @param arguments with the values that they have when nobody types any; empty where one must be typed
    public record AgentTypeInfo(String type, String description, boolean needsRobot, List<ArgumentInfo> arguments) {}

    /// Why something was not done.
    public record Refused(String message, List<FieldError> problems) {}

    /// @param where what of a [Restart] or [SweepWish] is wrong (`seed`, `arguments.hunters`), or file and place
    /// @param remedy what to try; empty when nobody can tell
    public record FieldError(String where, String message, String remedy) {}
}
