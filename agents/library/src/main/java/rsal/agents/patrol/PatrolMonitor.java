package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.agents.driving.PlaceQuest;
import rsal.agents.driving.PlaceSearch.Wanted;
import rsal.agents.patrol.strategy.Bids;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.PluginChoice;

/// Has a team watch places, and says for how long nobody was at them. Unless robots bid for places, it only
/// announces the places and the strategy: the robots decide themselves ([PatrolMember]), and go on without it.
/// When one of them sees an intruder, some go there first, and the others go on.
final class PatrolMonitor {
    private static final Duration LOOK = Duration.ofSeconds(5); // for a robot that can find places

    private final AgentContext self;
    private final PluginChoice strategy;
    private final Duration stay;
    private final Optional<Wanted> wanted;
    private final PlaceQuest quest;
    private final Team team;
    private final Alarms alarms;
    private final Optional<VisitBids> bids;
    private final Map<String, PoseReport> members = new TreeMap<>(); // by agent
    private List<Point2d> mapFromPlaces = List.of();
    private Instant[] visited = {};

    PatrolMonitor(AgentContext self, Arguments arguments) {
        this.self = self;
        this.strategy = arguments.get(Patrol.STRATEGY);
        this.stay = arguments.seconds(Patrol.STAY_TIME);
        this.quest = new PlaceQuest(self, this::watch);
        Rules rules = Rules.DEFAULT.withObjective(Objective.SUM).oneAtATime().withTries(0);
        this.team = new Team(self, rules, this::note);
        this.alarms = new Alarms(self, arguments, team);
        this.bids = strategy.plugin() instanceof Bids
                ? Optional.of(
                        new VisitBids(self, team, stay, strategy.arguments().get(Bids.URGENCY), this::idle))
                : Optional.empty();
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
        self.subscribe(Visited.TOPIC, message -> visit(message.content().mapFromPlace()));
        self.directory().onDeparture(went -> members.remove(went.agent().name()));
        self.scheduler().every(LOOK, this::look);
        self.publish(PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL)); // some may have been there for long
        team.begin();
        alarms.begin();
        self.state("looking who is there");
    }

    private void look() {
        wanted.filter(_ -> !quest.isFound()).ifPresent(places -> quest.want(places, List.copyOf(members.keySet())));
        order();
        publish();
    }

    private void watch(List<Point2d> mapFromThem) {
        mapFromPlaces = List.copyOf(mapFromThem);
        visited = new Instant[mapFromPlaces.size()];
        Arrays.fill(visited, self.scheduler().instant());
        self.publish(Watch.TOPIC, new Watch(mapFromPlaces));
        bids.ifPresentOrElse(auction -> auction.begin(mapFromPlaces), this::order);
    }

    /// Again and again, for those that come later.
    private void order() {
        if (bids.isEmpty() && !mapFromPlaces.isEmpty()) {
            self.publish(PatrolOrder.TOPIC, new PatrolOrder(mapFromPlaces, strategy, stay));
        }
    }

    private void visit(Point2d mapFromPlace) {
        int place = mapFromPlaces.indexOf(mapFromPlace);
        if (place >= 0) {
            visited[place] = self.scheduler().instant();
            publish();
        }
    }

    /// Since when nobody was there [s].
    private double idle(int place) {
        return Duration.between(visited[place], self.scheduler().instant()).toMillis() / 1000.0;
    }

    private void note(Team.Event event) {
        switch (event.job()) {
            case Visit visit -> {
                if (event instanceof Team.Event.Done) {
                    visit(visit.mapFromPlace().position());
                }
                bids.ifPresent(auction -> auction.note(event));
            }
            case Meet meet when event instanceof Team.Event.Done -> alarms.done(meet);
            default -> {} // they go on until they have met it or nobody sees it
        }
        publish();
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
