package rsal.agents.formation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.presence.FailureDetector;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agent.team.Assignment;
import rsal.agents.driving.GoalService;
import rsal.agents.formation.SurveyService.Wanted;
import rsal.agents.parts.AgentWords;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;

/// Moves a formation as one body along a way and tells each robot where its place in it is: a virtual structure (M.
/// Lewis, K.-H. Tan, High Precision Formation Control of Mobile Robots Using Virtual Structures, Autonomous Robots
/// 4, 1997). The structure waits for robots that lag (the formation feedback of B. Young, R. Beard, J. Kelsey, A
/// Control Scheme for Improving Multi-Vehicle Formation Maneuvers, ACC 2001). Places are allotted with the least
/// sum of squared distances, for then straight ways to them do not cross (M. Turpin, N. Michael, V. Kumar, CAPT,
/// International Journal of Robotics Research 33, 2014), again whenever the shape or the team changes.
///
/// Differs from these in that robots drive to their places by their own navigators, around whatever is in the way; and
/// in that the structure is a column that follows the way wherever a robot's planner finds no room for the shape.
final class VirtualStructure {
    private static final Duration BEAT = Duration.ofMillis(500);
    private static final Duration AHEAD = Duration.ofSeconds(1); // that robots aim
    private static final Duration TO_GATHER = Duration.ofSeconds(2); // until all have been heard
    private static final Duration PING = Duration.ofSeconds(1);
    private static final Duration PAUSE = Duration.ofSeconds(5); // before somebody is asked again
    private static final Duration PATIENCE = Duration.ofSeconds(30); // with one that lags
    private static final double NEAR = 0.6; // m; no reason to wait
    private static final double FAR = 2; // m; a reason to stand still
    private static final double LEAST_REACH = 1; // m

    private final AgentContext self;
    private final String robots;
    private final FormationShape shape;
    private final double spacing;
    private final double speed;
    private final List<Pose2d> mapFromRoute;
    private final FailureDetector roll;
    private final Request<Wanted, FormationCorridor> surveys;
    private final Request<NewGoal, GoalReached> drives;
    private final Map<String, PoseReport> reports = new HashMap<>(); // newest, by robot
    private final Map<String, Instant> lagging = new HashMap<>(); // since when, by robot
    private final Set<String> askedInVain = new HashSet<>(); // agents
    private NavigableMap<String, Integer> places = new TreeMap<>(); // by robot
    private @Nullable FormationCorridor lane;
    private int surveyed; // for how many
    private boolean asking;
    private boolean column;
    private boolean formed;
    private boolean arrived;
    private double way; // made [m]

    VirtualStructure(AgentContext self, Arguments arguments) {
        this.self = self;
        this.robots = arguments.get(Formation.ROBOTS);
        this.shape = FormationShape.of(arguments.get(Formation.SHAPE));
        this.spacing = arguments.get(Formation.SPACING);
        this.speed = arguments.get(Formation.SPEED);
        this.mapFromRoute = AgentWords.poses(arguments.get(Formation.ROUTE));
        this.roll = new FailureDetector(self, PING, arguments.seconds(Formation.TIMEOUT), _ -> {});
        this.surveys = SurveyService.service(self);
        this.drives = GoalService.service(self);
    }

    void begin() {
        self.subscribe(PoseReport.TOPIC, message -> {
            PoseReport report = message.content();
            if (robots.equals(NewGoal.ALL) || report.isFrom(robots)) {
                reports.put(report.robot(), report);
            }
        });
        roll.begin();
        self.publish(PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL)); // those who stand may have told it long ago
        self.scheduler().after(TO_GATHER, () -> self.scheduler().every(BEAT, this::beat));
        self.state("looking who is there");
    }

    private void beat() {
        NavigableMap<String, Pose2d> team = team();
        if (arrived || team.isEmpty()) {
            return;
        }
        if (surveyed != team.size()) {
            survey(team.size());
        }
        FormationCorridor now = lane;
        if (now != null) {
            go(now, team);
        }
    }

    /// Where robots are that are heard, by id.
    private NavigableMap<String, Pose2d> team() {
        var team = new TreeMap<String, Pose2d>();
        for (FailureDetector.Member member : roll.present()) {
            PoseReport report = reports.get(member.robot());
            if (report != null) {
                team.put(report.robot(), report.mapFromBase());
            }
        }
        return team;
    }

    /// Has somebody look where a formation of so many has room.
    private void survey(int robots) {
        if (asking) {
            return;
        }
        List<String> able = roll.present().stream()
                .map(FailureDetector.Member::name)
                .filter(agent -> self.directory().capabilities(agent).contains(SurveyService.CAPABILITY))
                .toList();
        Optional<String> next =
                able.stream().filter(agent -> !askedInVain.contains(agent)).findFirst();
        if (next.isEmpty()) {
            askedInVain.clear();
            if (able.isEmpty()) {
                self.state("waiting for a robot that has a planner");
            }
            return;
        }
        asking = true;
        List<Point2d> offsets = shape.places(robots, spacing);
        double radius = offsets.stream()
                .mapToDouble(place -> Math.hypot(place.x(), place.y()))
                .max()
                .orElse(0);
        var wanted = new Wanted(mapFromRoute, offsets, Math.max(LEAST_REACH, radius / 2), radius);
        surveys.ask(next.get(), wanted, ending -> {
            if (ending instanceof ConversationResult.Informed<FormationCorridor>(FormationCorridor found)) {
                asking = false;
                askedInVain.clear();
                surveyed = robots;
                start(found);
            } else {
                askedInVain.add(next.get());
                self.state("has no way. " + why(ending));
                self.scheduler().after(PAUSE, () -> asking = false);
            }
        });
    }

    private static String why(ConversationResult<FormationCorridor> ending) {
        return switch (ending) {
            case ConversationResult.Failed<FormationCorridor>(String why) -> why;
            case ConversationResult.Refused<FormationCorridor>(String why) -> why;
            case ConversationResult.NotUnderstood<FormationCorridor>(String why) -> why;
            case ConversationResult.Silent<FormationCorridor>(String why) -> why;
            case ConversationResult.Informed<FormationCorridor> _, ConversationResult.Cancelled<FormationCorridor> _ ->
                "";
        };
    }

    /// The same way as before, with more room or less; or the first one.
    private void start(FormationCorridor found) {
        if (lane == null) {
            column = !found.fits(0, false);
            way = column
                    ? Math.min(found.length(), (surveyed - 1) * spacing)
                    : 0; // the column's end is on the way, too
        }
        lane = found;
    }

    private void go(FormationCorridor now, NavigableMap<String, Pose2d> team) {
        boolean narrow = shape == FormationShape.COLUMN || !now.fits(way, column);
        if (narrow != column || !places.keySet().equals(team.keySet())) {
            column = narrow;
            allot(now, team);
        }
        double worst = worst(now, team);
        formed |= worst <= NEAR;
        double share = Math.clamp((FAR - worst) / (FAR - NEAR), 0, 1);
        if (way >= now.length() && formed) {
            arrive(now, team);
            return;
        }
        way = Math.min(now.length(), way + share * speed * BEAT.toMillis() / 1e3);
        publish(now, share);
    }

    private void allot(FormationCorridor now, NavigableMap<String, Pose2d> team) {
        List<Pose2d> slots = slots(now, way, team.size());
        var costs = new TreeMap<String, double[]>();
        team.forEach((robot, mapFromBase) -> costs.put(
                robot,
                slots.stream()
                        .mapToDouble(mapFromBase::distanceTo)
                        .map(distance -> distance * distance)
                        .toArray()));
        places = new TreeMap<>(Assignment.cheapest(costs));
        formed = false;
        lagging.clear();
    }

    /// How far the one is off that is farthest off, of those for whom it waits [m].
    private double worst(FormationCorridor now, NavigableMap<String, Pose2d> team) {
        List<Pose2d> slots = slots(now, way, team.size());
        Instant instant = self.scheduler().instant();
        double worst = 0;
        for (var place : places.entrySet()) {
            Pose2d mapFromBase = Objects.requireNonNull(team.get(place.getKey())); // those of the team have places
            double off = mapFromBase.distanceTo(slots.get(place.getValue()));
            if (off <= NEAR) {
                lagging.remove(place.getKey());
            } else {
                lagging.putIfAbsent(place.getKey(), instant);
            }
            Instant since = lagging.getOrDefault(place.getKey(), instant);
            if (!since.plus(patience()).isBefore(instant)) {
                worst = Math.max(worst, off);
            }
        }
        return worst;
    }

    /// For a robot to come from anywhere in the formation to anywhere else.
    private Duration patience() {
        return PATIENCE.plusMillis(Math.round(2000 * places.size() * spacing / speed));
    }

    private List<Pose2d> slots(FormationCorridor now, double at, int count) {
        var slots = new ArrayList<Pose2d>();
        for (int i = 0; i < count; i++) {
            if (column) {
                slots.add(now.onWay(at - i * spacing));
            } else {
                Point2d place = shape.place(i, count, spacing);
                slots.add(now.beside(at).compose(new Pose2d(place.x(), place.y(), 0)));
            }
        }
        return slots;
    }

    private void publish(FormationCorridor now, double share) {
        int count = places.size();
        List<Pose2d> here = slots(now, way, count);
        List<Pose2d> later = slots(now, way + share * speed * AHEAD.toMillis() / 1e3, count);
        var slots = new TreeMap<String, FormationSlots.Slot>();
        places.forEach((robot, place) -> slots.put(robot, new FormationSlots.Slot(here.get(place), later.get(place))));
        String name = (column ? FormationShape.COLUMN : shape).word();
        self.publish(FormationSlots.TOPIC, new FormationSlots(name, formed, AHEAD, slots));
        self.state("%s a %s of %d".formatted(formed ? "leading" : "forming", name, count));
        self.show("way", String.format(Locale.ROOT, "%.0f of %.0f m", way, now.length()));
    }

    private void arrive(FormationCorridor now, NavigableMap<String, Pose2d> team) {
        arrived = true;
        List<Pose2d> slots = slots(now, way, places.size());
        for (FailureDetector.Member member : roll.present()) {
            Integer place = places.get(member.robot());
            if (place != null && team.containsKey(member.robot())) {
                var order = new NewGoal(member.robot(), slots.get(place));
                drives.ask(member.name(), order, _ -> {});
            }
        }
        self.state("has arrived");
    }
}
