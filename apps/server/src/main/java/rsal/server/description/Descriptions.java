package rsal.server.description;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentType;
import rsal.agent.bdi.Mind;
import rsal.agent.platform.AgentPlatform;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.device.Health;
import rsal.engine.LiveRun;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.DeviceView;
import rsal.engine.report.LossReason;
import rsal.engine.report.MindChange;
import rsal.engine.report.OperatorMessage;
import rsal.engine.report.ReceivedMessage;
import rsal.engine.report.Reception;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.SentGoal;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.engine.report.Teammate;
import rsal.engine.report.TopicTraffic;
import rsal.robot.RobotModel;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.Scenario;
import rsal.scene.Scene;
import rsal.server.message.Messages.AgentDetails;
import rsal.server.message.Messages.AgentInside;
import rsal.server.message.Messages.AgentStatus;
import rsal.server.message.Messages.AgentTypeInfo;
import rsal.server.message.Messages.AgentTypes;
import rsal.server.message.Messages.ArgumentInfo;
import rsal.server.message.Messages.ArgumentInfo.ArgumentKind;
import rsal.server.message.Messages.BeliefInfo;
import rsal.server.message.Messages.ChangeInfo;
import rsal.server.message.Messages.Communication;
import rsal.server.message.Messages.ConfigurationInfo;
import rsal.server.message.Messages.Details;
import rsal.server.message.Messages.DeviceDetails;
import rsal.server.message.Messages.DrawnMap;
import rsal.server.message.Messages.Ending;
import rsal.server.message.Messages.EventInfo;
import rsal.server.message.Messages.FieldInfo;
import rsal.server.message.Messages.FieldKind;
import rsal.server.message.Messages.GoalInfo;
import rsal.server.message.Messages.HearingInfo;
import rsal.server.message.Messages.LinkInfo;
import rsal.server.message.Messages.Links;
import rsal.server.message.Messages.MailInfo;
import rsal.server.message.Messages.MapInfo;
import rsal.server.message.Messages.MetricInfo;
import rsal.server.message.Messages.MindInfo;
import rsal.server.message.Messages.MotorsOff;
import rsal.server.message.Messages.PlanInfo;
import rsal.server.message.Messages.ProgramInfo;
import rsal.server.message.Messages.RealDetails;
import rsal.server.message.Messages.RecordingInfo;
import rsal.server.message.Messages.RobotDetails;
import rsal.server.message.Messages.RobotModelInfo;
import rsal.server.message.Messages.RobotModels;
import rsal.server.message.Messages.RobotStatus;
import rsal.server.message.Messages.Routine;
import rsal.server.message.Messages.RoutineInfo;
import rsal.server.message.Messages.RunInfo;
import rsal.server.message.Messages.SaidInfo;
import rsal.server.message.Messages.SayableInfo;
import rsal.server.message.Messages.Sayables;
import rsal.server.message.Messages.SentGoalInfo;
import rsal.server.message.Messages.SettingInfo;
import rsal.server.message.Messages.StatusInfo;
import rsal.server.message.Messages.TalkInfo;
import rsal.server.message.Messages.TopicInfo;
import rsal.server.message.Messages.Topics;
import rsal.server.message.Messages.Wanted;
import rsal.settings.Parameter;

/// Puts a run into messages.
///
/// Longer than 500 lines, since it is a list: a method for each message.
public final class Descriptions {
    private static final Duration TOO_SILENT = Duration.ofSeconds(1);
    private static final int MOST_OF_A_MIND = 50; // beliefs, and goals
    private static final int MOST_OF_A_GOAL = 20; // plans, and steps
    private static final int MOST_OF_A_PROGRAM = 100; // rules, and plans
    private static final int MOST_WORDS = 200; // characters
    private static final int MOST_CODE = 1000; // characters of a rule, or of a plan

    /// Of no other server at the same address, before or after.
    private static final String PROCESS = ProcessHandle.current().pid()
            + ProcessHandle.current()
                    .info()
                    .startInstant()
                    .map(start -> "-" + start.toEpochMilli())
                    .orElse("");

    private Descriptions() {}

    /// @param team all robots that are or were there
    public static RunInfo run(int number, RunPlan plan, List<Teammate> team) {
        return run(number, plan, team, Optional.empty());
    }

    public static RunInfo run(int number, RunPlan plan, List<Teammate> team, Optional<RecordingInfo> recording) {
        Scenario scenario = plan.scenario();
        return new RunInfo(
                number,
                PROCESS,
                scenario.name(),
                scenario.title(),
                scenario.description(),
                plan.configuration(),
                configurations(scenario),
                arguments(plan),
                Long.toString(plan.seed()),
                plan.step().toNanos() / 1e9,
                map(plan.mapName(), plan.scene()),
                team.stream().map(AppearanceEncoder::robot).toList(),
                plan.metrics().stream().map(Descriptions::metric).toList(),
                plan.options().mas().orElse(""),
                scenario.isEdited(),
                recording);
    }

    public static List<ConfigurationInfo> configurations(Scenario scenario) {
        return scenario.configurations().stream()
                .map(configuration -> new ConfigurationInfo(
                        configuration.name(), configuration.title(), scenario.isInRealTime(configuration.name())))
                .toList();
    }

    public static List<ArgumentInfo> arguments(RunPlan plan) {
        return plan.scenario().arguments().stream()
                .map(argument -> argument(argument, plan))
                .toList();
    }

    private static ArgumentInfo argument(Parameter<?> parameter, RunPlan plan) {
        return argument(
                parameter,
                String.valueOf(plan.arguments().get(parameter.name())),
                plan.options().arguments().containsKey(parameter.name()));
    }

    public static RobotModels robotModels(List<RobotModel> models) {
        return new RobotModels(models.stream()
                .map(model -> new RobotModelInfo(model.name(), model.title()))
                .toList());
    }

    public static AgentTypes agentTypes(List<AgentType> types) {
        return new AgentTypes(types.stream()
                .map(type -> new AgentTypeInfo(
                        type.key(),
                        type.description(),
                        !type.needs().isEmpty(),
                        type.parameters().stream()
                                .map(parameter -> argument(
                                        parameter,
                                        parameter
                                                .fallback()
                                                .map(String::valueOf)
                                                .orElse(""),
                                        false))
                                .toList()))
                .toList());
    }

    private static ArgumentInfo argument(Parameter<?> parameter, String value, boolean typed) {
        return new ArgumentInfo(
                parameter.name(),
                kind(parameter.kind()),
                value,
                typed,
                finite(parameter.min()),
                finite(parameter.max()),
                parameter.kind() == Parameter.Kind.TEXT ? parameter.options() : List.of(),
                parameter.unit(),
                parameter.description());
    }

    /// As one types it: names of robots and places are texts, too.
    private static ArgumentKind kind(Parameter.Kind kind) {
        return switch (kind) {
            case NUMBER -> ArgumentKind.NUMBER;
            case INTEGER -> ArgumentKind.INTEGER;
            case FLAG -> ArgumentKind.FLAG;
            case TEXT, ROBOTS, PLACES, POINTS, PLUGIN, PLUGINS, TEXTS -> ArgumentKind.TEXT;
        };
    }

    private static Optional<Double> finite(double value) {
        return Double.isFinite(value) ? Optional.of(value) : Optional.empty();
    }

    private static MetricInfo metric(RunPlan.MetricDefinition measured) {
        return new MetricInfo(measured.name(), measured.unit(), finite(measured.min()), finite(measured.max()));
    }

    private static MapInfo map(String name, Scene scene) {
        OccupancyGrid map = scene.map();
        return new MapInfo(
                name,
                map.width(),
                map.height(),
                map.resolution(),
                map.originX(),
                map.originY(),
                FloorPlan.colors(scene).stream().map(Rgb::toString).toList(),
                FloorPlan.height(scene));
    }

    static Communication communication(List<Reception> all) {
        return new Communication(hearings(all));
    }

    public static Links links(Answer.Linked reported) {
        return new Links(
                reported.links().stream()
                        .map(link -> new LinkInfo(
                                link.one(),
                                link.other(),
                                link.there().open(),
                                link.back().open(),
                                link.there().used(),
                                link.back().used()))
                        .toList(),
                reported.ofChosen());
    }

    public static Sayables sayable(List<OperatorMessage> all) {
        return new Sayables(all.stream()
                .map(one -> new SayableInfo(
                        one.topic(),
                        one.fields().stream()
                                .map(field -> new FieldInfo(
                                        field.name(),
                                        FieldKind.valueOf(field.kind().name()),
                                        field.choices()))
                                .toList()))
                .toList());
    }

    static Topics topics(List<TopicTraffic> all) {
        return new Topics(all.stream().map(Descriptions::topic).toList());
    }

    private static TopicInfo topic(TopicTraffic topic) {
        return new TopicInfo(
                topic.topic(),
                topic.said(),
                topic.heard(),
                topic.lost().getOrDefault(LossReason.RANGE, 0L),
                topic.lost().getOrDefault(LossReason.CHANCE, 0L),
                topic.lost().getOrDefault(LossReason.BANDWIDTH, 0L),
                topic.lost().getOrDefault(LossReason.FAULT, 0L));
    }

    private static List<HearingInfo> hearings(List<Reception> all) {
        return all.stream()
                .map(one -> new HearingInfo(one.sender(), one.listener(), one.topic(), one.heard(), one.lost()))
                .toList();
    }

    public static AgentInside inside(AgentInspection agent) {
        return new AgentInside(
                agent.name(),
                agent.planned().map(Descriptions::settings).orElse(List.of()),
                agent.shown().map(Descriptions::status),
                agent.shown().map(AgentPlatform.View::state).orElse(""),
                beliefs(agent.shown().map(AgentPlatform.View::beliefs).orElse(Map.of())),
                agent.mind().map(Descriptions::mind),
                agent.program().map(Descriptions::program),
                agent.history().stream().map(Descriptions::change).toList(),
                agent.mail().map(all -> all.stream().map(Descriptions::mail).toList()),
                agent.talks().stream()
                        .map(said -> new TalkInfo(
                                said.time().toNanos() / 1e9,
                                said.from(),
                                said.to(),
                                said.conversation(),
                                said.protocol(),
                                said.act(),
                                said.words(),
                                said.times()))
                        .toList(),
                hearings(agent.hearings()));
    }

    private static ChangeInfo change(MindChange change) {
        return new ChangeInfo(
                change.time().toNanos() / 1e9,
                ChangeInfo.Kind.valueOf(change.kind().name()),
                clip(change.name()),
                change.words());
    }

    private static MailInfo mail(ReceivedMessage mail) {
        return new MailInfo(mail.time().toNanos() / 1e9, mail.from(), mail.forAll(), mail.topic(), mail.words());
    }

    private static AgentDetails.Status status(AgentPlatform.View view) {
        return AgentDetails.Status.valueOf(view.status().name());
    }

    private static List<BeliefInfo> beliefs(Map<String, String> all) {
        return all.entrySet().stream()
                .limit(MOST_OF_A_MIND)
                .map(belief -> new BeliefInfo(clip(belief.getKey()), clip(belief.getValue())))
                .toList();
    }

    private static List<SettingInfo> settings(PlannedAgent agent) {
        Map<String, Object> values = agent.arguments().asMap();
        return agent.type().parameters().stream()
                .map(parameter -> new SettingInfo(
                        parameter.name(),
                        typed(Objects.requireNonNull(values.get(parameter.name()))),
                        parameter.fallback().map(Descriptions::typed),
                        parameter.unit(),
                        parameter.description()))
                .toList();
    }

    /// @param value Double, Long, String or Boolean
    static String typed(Object value) {
        String words = clip(String.valueOf(value));
        return value instanceof Double ? words.replaceFirst("\\.0$", "") : words;
    }

    private static MindInfo mind(Mind.View mind) {
        return new MindInfo(
                beliefs(mind.beliefs()),
                mind.goals().stream()
                        .limit(MOST_OF_A_MIND)
                        .map(Descriptions::goal)
                        .toList(),
                Math.max(0, mind.beliefs().size() - MOST_OF_A_MIND)
                        + Math.max(0, mind.goals().size() - MOST_OF_A_MIND));
    }

    private static ProgramInfo program(Mind.Program program) {
        return new ProgramInfo(
                program.rules().stream()
                        .limit(MOST_OF_A_PROGRAM)
                        .map(rule -> clip(rule, MOST_CODE))
                        .toList(),
                program.plans().entrySet().stream()
                        .limit(MOST_OF_A_PROGRAM)
                        .map(plan -> new PlanInfo(clip(plan.getKey()), clip(plan.getValue(), MOST_CODE)))
                        .toList(),
                Math.max(0, program.rules().size() - MOST_OF_A_PROGRAM)
                        + Math.max(0, program.plans().size() - MOST_OF_A_PROGRAM));
    }

    private static GoalInfo goal(Mind.GoalView goal) {
        double urgency = goal.urgency();
        return new GoalInfo(
                clip(goal.name()),
                Wanted.valueOf(goal.state().name()),
                urgency == Math.rint(urgency) && Math.abs(urgency) < 1e9
                        ? String.valueOf((long) urgency)
                        : String.format(Locale.ROOT, "%.3g", urgency),
                clip(goal.plans()),
                clip(goal.steps()),
                clip(goal.failure()));
    }

    private static List<String> clip(List<String> words) {
        return words.stream().limit(MOST_OF_A_GOAL).map(Descriptions::clip).toList();
    }

    private static String clip(String words) {
        return clip(words, MOST_WORDS);
    }

    private static String clip(String words, int most) {
        return words.length() <= most ? words : words.substring(0, most) + "…";
    }

    public static MotorsOff motorsOff(Snapshot now) {
        return new MotorsOff(now.stopped(), ids(now, RobotView::stopped), ids(now, RobotView::switchedOff));
    }

    private static List<String> ids(Snapshot now, Predicate<RobotView> which) {
        return now.robots().stream().filter(which).map(RobotView::id).toList();
    }

    public static Details details(int number, Snapshot snapshot, CompletableFuture<RunResult> result) {
        return new Details(
                number,
                true,
                ending(result),
                snapshot.robots().stream().map(Descriptions::robot).toList(),
                snapshot.agents().stream().map(Descriptions::agent).toList());
    }

    private static Optional<Ending> ending(CompletableFuture<RunResult> result) {
        if (!result.isDone()) {
            return Optional.empty();
        }
        return Optional.of(result.handle((end, failure) -> end != null
                        ? new Ending(
                                end.outcome(),
                                end.simulatedSeconds(),
                                end.wallSeconds(),
                                end.eventHash(),
                                metrics(end),
                                end.outOfBounds(),
                                end.failed(),
                                end.unhandledGoals(),
                                "")
                        : new Ending("broken", 0, 0, "", Map.of(), List.of(), Map.of(), Map.of(), reason(failure)))
                .join());
    }

    private static Map<String, @Nullable Double> metrics(RunResult result) {
        var metrics = new LinkedHashMap<String, @Nullable Double>();
        result.metrics().forEach((name, value) -> metrics.put(name, value.isPresent() ? value.getAsDouble() : null));
        return metrics;
    }

    private static String reason(Throwable failure) {
        Throwable cause =
                failure instanceof CompletionException && failure.getCause() != null ? failure.getCause() : failure;
        return String.valueOf(cause.getMessage());
    }

    private static RobotDetails robot(RobotView robot) {
        return new RobotDetails(
                robot.id(),
                robot.gone(),
                robot.goneFor().map(time -> (double) time.toSeconds()),
                robot.inCharge(),
                robot.behavior(),
                robot.driver(),
                robot.stopped(),
                robot.estimate()
                        .map(estimate -> estimate.value().quality().name().toLowerCase(Locale.ROOT))
                        .orElse(""),
                robot.carried().stream().map(AppearanceEncoder::carried).toList(),
                robot.real().map(Descriptions::real),
                robot.devices().stream().map(Descriptions::device).toList(),
                robot.maps().stream().map(Descriptions::drawn).toList());
    }

    private static RealDetails real(RobotView.Real real) {
        return new RealDetails(
                real.proxy(),
                real.silence()
                        .filter(silence -> silence.compareTo(TOO_SILENT) > 0)
                        .map(silence -> (double) silence.toSeconds()));
    }

    private static DrawnMap drawn(RobotView.Drawn drawn) {
        return new DrawnMap(drawn.device(), drawn.map().time().toEpochMilli() / 1e3);
    }

    private static DeviceDetails device(DeviceView device) {
        return switch (device.health()) {
            case Health.Ok() -> device(device, DeviceDetails.Condition.OK, "");
            case Health.Stale(String reason) -> device(device, DeviceDetails.Condition.STALE, reason);
            case Health.Lost(String reason) -> device(device, DeviceDetails.Condition.LOST, reason);
        };
    }

    private static DeviceDetails device(DeviceView device, DeviceDetails.Condition condition, String reason) {
        return new DeviceDetails(device.name(), device.driver(), device.type(), condition, reason);
    }

    private static AgentDetails agent(AgentView agent) {
        AgentPlatform.View view = agent.view();
        return new AgentDetails(
                view.agent().name(),
                view.agent().role(),
                view.agent().type(),
                view.agent().robot(),
                status(view),
                view.state(),
                view.beliefs(),
                view.sent(),
                agent.lastSaid().map(time -> time.toMillis() / 1e3),
                agent.lastMessages());
    }

    public static StatusInfo status(int number, LiveRun run, Snapshot snapshot) {
        RunPlan plan = run.plan();
        return new StatusInfo(
                number,
                plan.scenario().name(),
                plan.configuration(),
                Long.toString(plan.seed()),
                snapshot.time().toNanos() / 1e9,
                snapshot.paused(),
                snapshot.stopped(),
                snapshot.outcome().orElse(""),
                snapshot.robots().stream().map(Descriptions::status).toList(),
                snapshot.agents().stream()
                        .map(agent -> agentStatus(agent.view()))
                        .toList(),
                run.goals().stream().map(Descriptions::goal).toList());
    }

    private static AgentStatus agentStatus(AgentPlatform.View view) {
        return new AgentStatus(view.agent().name(), view.agent().robot(), status(view), view.state());
    }

    private static SentGoalInfo goal(SentGoal goal) {
        return new SentGoalInfo(
                goal.id(),
                goal.robot(),
                goal.mapFromGoal().x(),
                goal.mapFromGoal().y(),
                goal.mapFromGoal().theta(),
                goal.status().word(),
                goal.why(),
                goal.sent().toNanos() / 1e9,
                goal.ended().map(ended -> ended.toNanos() / 1e9));
    }

    /// Empty while it goes on.
    public static String outcome(LiveRun run, Snapshot snapshot) {
        return run.result().toCompletableFuture().isCompletedExceptionally()
                ? "broken"
                : snapshot.outcome().orElse("");
    }

    private static RobotStatus status(RobotView robot) {
        Optional<Pose2d> mapFromBase = robot.truth()
                .or(() -> robot.estimate().map(estimate -> estimate.value().mapFromBase()));
        return new RobotStatus(
                robot.id(),
                robot.role(),
                mapFromBase.map(Pose2d::x),
                mapFromBase.map(Pose2d::y),
                mapFromBase.map(Pose2d::theta),
                robot.gone(),
                robot.stopped(),
                robot.driver().isEmpty() ? robot.inCharge() : "driven by keys");
    }

    public static EventInfo event(RunEvent event) {
        return new EventInfo(
                event.sequence(),
                event.time().toNanos() / 1e9,
                event.kind(),
                event.subject(),
                event.text(),
                event.said().map(Descriptions::said));
    }

    /// @param topic of which all is told that is kept; maybe none
    public static Routine routine(Map<String, List<SentMessage>> byTopic, String topic) {
        return new Routine(
                byTopic.keySet().stream().sorted().toList(),
                byTopic.getOrDefault(topic, List.of()).stream()
                        .map(said ->
                                new RoutineInfo(said.time().toNanos() / 1e9, said.from(), said.words(), said(said)))
                        .toList());
    }

    private static SaidInfo said(SentMessage said) {
        return new SaidInfo(said.to(), said.topic(), said.conversation(), said.protocol(), said.act());
    }
}
