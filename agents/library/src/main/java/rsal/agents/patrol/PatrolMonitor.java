package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.agents.driving.PlaceQuest;
import rsal.agents.driving.PlaceSearch.Wanted;
import rsal.agents.parts.AgentWords;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;

/// Watches places by a team. By bids, each place is a job again as soon as somebody has been there, the more urgent
/// the longer nobody was: what A. Machado et al., "Multi-agent patrolling" (2002), call idleness, weighed against
/// the way as in A. Almeida et al., "Recent advances on multi-agent patrolling" (2004). The other two ways are what
/// to compare with: along a cycle, on which the robots begin evenly spaced, and at random. When one of them sees an
/// intruder, some go there first, and the others go on.
final class PatrolMonitor {
    private static final Duration SEEN = Duration.ofSeconds(10); // nobody need look again before
    private static final Duration LOOK = Duration.ofSeconds(5); // for robots that can find places, or have come

    private final AgentContext self;
    private final String strategy;
    private final double urgency;
    private final Duration stay;
    private final Optional<Wanted> wanted;
    private final PlaceQuest quest;
    private final Team team;
    private final Alarms alarms;
    private final Map<String, PoseReport> members = new TreeMap<>(); // by agent
    private final Map<String, Integer> nextOf = new HashMap<>(); // place by robot, along the cycle
    private final Map<String, Integer> placeOf = new HashMap<>(); // by job
    private List<Pose2d> mapFromPlaces = List.of();
    private Instant[] visited = {};

    PatrolMonitor(AgentContext self, Arguments arguments) {
        this.self = self;
        this.strategy = arguments.get(Patrol.STRATEGY);
        this.urgency = arguments.get(Patrol.URGENCY);
        this.stay = arguments.seconds(Patrol.STAY_TIME);
        this.quest = new PlaceQuest(self, this::watch);
        Rules rules = Rules.DEFAULT.withObjective(Objective.SUM).oneAtATime().withTries(0);
        this.team = new Team(self, rules, this::note);
        this.alarms = new Alarms(self, arguments, team);
        List<Point2d> given = arguments.get(Patrol.PLACES);
        this.wanted = given.isEmpty()
                ? Optional.of(new Wanted(arguments.get(Patrol.COUNT), arguments.get(PlaceQuest.CLEARANCE)))
                : Optional.empty();
        if (!given.isEmpty()) {
            self.scheduler().execute(() -> watch(given));
        }
    }

    void begin() {
        self.subscribe(PoseReport.TOPIC, message -> members.put(message.sender(), message.content()));
        self.directory().onDeparture(went -> members.remove(went.agent().name()));
        self.scheduler().every(LOOK, this::look);
        self.publish(PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL)); // some may have been there for long
        team.begin();
        alarms.begin();
        self.state("looking who is there");
    }

    private void look() {
        wanted.filter(_ -> !quest.isFound()).ifPresent(places -> quest.want(places, List.copyOf(members.keySet())));
        sendNewcomers();
        publish();
    }

    private void watch(List<Point2d> mapFromThem) {
        mapFromPlaces = AgentWords.poses(mapFromThem);
        visited = new Instant[mapFromPlaces.size()];
        Arrays.fill(visited, self.scheduler().instant());
        self.publish(Watch.TOPIC, new Watch(mapFromThem));
        if (strategy.equals("bids")) {
            for (int place = 0; place < visited.length; place++) {
                call(place);
            }
        }
    }

    /// Calls for bids for a place.
    private void call(int place) {
        add(new Visit(name(place), mapFromPlaces.get(place), stay, Optional.empty()), place);
    }

    private void add(Visit visit, int place) {
        placeOf.put(visit.name(), place);
        team.add(visit, () -> urgency * idle(place));
    }

    private String name(int place) {
        return "visit " + AgentWords.place(mapFromPlaces.get(place));
    }

    /// Since when nobody was there [s].
    private double idle(int place) {
        return Duration.between(visited[place], self.scheduler().instant()).toMillis() / 1000.0;
    }

    /// Sets robots off that have come, where each goes its own way.
    private void sendNewcomers() {
        if (strategy.equals("bids") || mapFromPlaces.isEmpty()) {
            return;
        }
        for (PoseReport member : List.copyOf(members.values())) {
            if (!nextOf.containsKey(member.robot())) {
                nextOf.put(member.robot(), firstFor(nextOf.size()));
                sendOn(member.robot());
            }
        }
    }

    /// Evenly spaced for those who are there at first.
    private int firstFor(int number) {
        return number * mapFromPlaces.size() / Math.max(number + 1, members.size());
    }

    private void sendOn(String robot) {
        int place = strategy.equals("random")
                ? self.random().nextInt(mapFromPlaces.size())
                : nextOf.getOrDefault(robot, 0) % mapFromPlaces.size();
        nextOf.put(robot, place + 1);
        String name = "%s by %s".formatted(name(place), robot);
        add(new Visit(name, mapFromPlaces.get(place), stay, Optional.of(robot)), place);
    }

    private void note(Team.Event event) {
        switch (event.job()) {
            case Visit visit -> note(event, visit.robot());
            case Meet meet when event instanceof Team.Event.Done -> alarms.done(meet);
            default -> {} // they go on until they have met it or nobody sees it
        }
        publish();
    }

    /// @param only id of the robot that alone goes there
    private void note(Team.Event event, Optional<String> only) {
        int place = placeOf.getOrDefault(event.job().name(), 0);
        switch (event) {
            case Team.Event.Done done -> {
                visited[place] = self.scheduler().instant();
                String robot = self.directory()
                        .find(done.member())
                        .map(Directory.Entry::robot)
                        .orElse("");
                self.publish(
                        Visited.TOPIC,
                        new Visited(robot, mapFromPlaces.get(place).position()));
                only.ifPresentOrElse(this::sendOn, () -> self.scheduler().after(SEEN, () -> call(place)));
            }
            case Team.Event.Returned _ ->
                only.ifPresent(
                        robot -> { // it can't get there now: it goes on
                            team.withdraw(event.job().name());
                            sendOn(robot);
                        });
            case Team.Event.Allotted _, Team.Event.GivenUp _ -> {}
        }
    }

    private void publish() {
        if (mapFromPlaces.isEmpty()) {
            return;
        }
        var idle = new ArrayList<Double>();
        for (int place = 0; place < visited.length; place++) {
            idle.add(idle(place));
        }
        double worst = idle.stream().mapToDouble(Double::doubleValue).max().orElse(0);
        double mean = idle.stream().mapToDouble(Double::doubleValue).average().orElse(0);
        String watching = String.format(
                Locale.ROOT, "watching %d places, left alone for %.0f s, at most %.0f s", idle.size(), mean, worst);
        self.state(alarms.view().map(alarm -> alarm + ", " + watching).orElse(watching));
    }
}
