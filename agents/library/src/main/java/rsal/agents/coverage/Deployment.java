package rsal.agents.coverage;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
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
import rsal.agents.driving.PathCostService;
import rsal.agents.driving.PathCostService.Costs;
import rsal.agents.driving.PathCostService.Places;
import rsal.agents.driving.PlaceQuest;
import rsal.agents.driving.PlaceSearch.Wanted;
import rsal.agents.parts.AgentWords;
import rsal.agents.parts.TargetTracks;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;

/// Spreads a team over places: asks each robot what the ways there would cost it, gives each one place by the
/// [Assignment] that is best for all, and sends it there. Robots that can't tell costs are taken to drive straight;
/// those that do not answer are left out, and their place is given to another. Has places found when it is given
/// none ([PlaceQuest]). A robot that has reached its place is free to do what else it has to do, and is sent back the
/// next time.
final class Deployment {
    private static final Duration TO_SETTLE = Duration.ofSeconds(2); // until localizers have told where robots are
    private static final Duration TO_ANSWER = Duration.ofMillis(500);
    private static final Duration BETWEEN = Duration.ofSeconds(1); // changes that come together are one

    private static final double AWAY = 1; // m, from its place: more than localizers are wrong by

    private final AgentContext self;
    private final String robots;
    private final boolean areGiven;
    private final int count;
    private final double clearance;
    private final String objective;
    private final PlaceQuest quest;
    private List<Pose2d> mapFromPlaces;
    private final Duration interval;
    private final FailureDetector roll;
    private final TargetTracks sightings;
    private final Request<Places, Costs> costs;
    private final Request<NewGoal, GoalReached> drives;
    private final Map<String, Integer> placeOf = new HashMap<>(); // by robot
    private final Map<String, String> agentOf = new HashMap<>(); // by robot
    private final Set<String> arrived = new HashSet<>();
    private final Map<String, Set<Integer>> vain = new HashMap<>(); // places where robots could not get
    private final Set<String> failed = new HashSet<>(); // to get to their place
    private @Nullable Round round;
    private boolean due;

    Deployment(AgentContext self, Arguments arguments) {
        this.self = self;
        this.robots = arguments.get(DeploymentAgent.ROBOTS);
        this.mapFromPlaces = AgentWords.poses(arguments.get(DeploymentAgent.PLACES));
        this.areGiven = !mapFromPlaces.isEmpty();
        this.count = arguments.get(DeploymentAgent.COUNT);
        this.clearance = arguments.get(PlaceQuest.CLEARANCE);
        this.objective = arguments.get(DeploymentAgent.OBJECTIVE);
        this.quest = new PlaceQuest(self, this::spreadOver);
        this.interval = arguments.seconds(DeploymentAgent.ALLOCATION_INTERVAL);
        Duration ping = arguments.seconds(DeploymentAgent.PING_INTERVAL);
        this.roll = new FailureDetector(self, ping, ping.multipliedBy(3), _ -> disperseSoon(BETWEEN));
        this.sightings = new TargetTracks(self.blackboard());
        this.costs = PathCostService.service(self);
        this.drives = GoalService.service(self);
    }

    void begin() {
        self.subscribe(PoseReport.TOPIC, message -> sightings.note(message.content()));
        roll.begin();
        disperseSoon(TO_SETTLE);
        if (!interval.isZero()) {
            self.scheduler().every(interval, this::disperse);
        }
        self.state("looking who is there");
    }

    private void disperseSoon(Duration delay) {
        if (!due) {
            due = true;
            self.scheduler().after(delay, () -> {
                due = false;
                disperse();
            });
        }
    }

    /// Asks all where they are, and those who answer what ways would cost.
    private void disperse() {
        self.publish(PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL));
        self.scheduler().after(TO_ANSWER, this::askForCosts);
    }

    /// Allots the places when all have answered or are silent.
    private void askForCosts() {
        var reports = new TreeMap<String, PoseReport>(); // by agent
        for (FailureDetector.Member member : roll.present()) {
            sightings
                    .report(member.robot())
                    .filter(this::isOurs)
                    .ifPresent(report -> reports.put(member.name(), report));
        }
        if (!areGiven && !areFoundFor(reports.keySet())) {
            return;
        }
        var next = new Round();
        round = next;
        reports.forEach(next::ask);
        next.allotWhenAllHaveAnswered();
    }

    /// Has places found when there are none yet, or for another number of robots.
    private boolean areFoundFor(Set<String> agents) {
        int wanted = count == 0 ? agents.size() : count;
        if (wanted == 0) {
            self.state("waiting for robots");
            return false;
        }
        quest.want(new Wanted(wanted, clearance, objective), List.copyOf(agents));
        return quest.isFound();
    }

    private void spreadOver(List<Point2d> mapFromFound) {
        mapFromPlaces = AgentWords.poses(mapFromFound);
        round = null; // it asked about others
        placeOf.clear();
        vain.clear();
        failed.clear();
        arrived.clear();
        disperseSoon(Duration.ZERO);
    }

    private boolean isOurs(PoseReport report) {
        return robots.equals(NewGoal.ALL) || report.isFrom(robots);
    }

    private void allot(NavigableMap<String, double[]> costsByRobot) {
        costsByRobot.forEach((robot, costs) -> {
            for (int place : vain.getOrDefault(robot, Set.of())) {
                costs[place] = Double.POSITIVE_INFINITY;
            }
        });
        Map<String, Integer> allotted = Assignment.even(costsByRobot);
        vain.keySet().retainAll(allotted.keySet()); // who gets nothing may try all of them again
        allotted.forEach((robot, place) -> {
            boolean goesThere = place.equals(placeOf.get(robot)) && !failed.contains(robot);
            if (!goesThere || hasLeft(robot, place)) {
                send(robot, place);
            }
        });
        placeOf.keySet().retainAll(allotted.keySet());
        publish();
    }

    /// Whether one that was at its place is there no more, as its own work or people took it elsewhere.
    private boolean hasLeft(String robot, int place) {
        Point2d mapFromPlace = mapFromPlaces.get(place).position();
        return arrived.contains(robot)
                && sightings
                        .of(robot)
                        .filter(mapFromBase -> mapFromBase.position().distanceTo(mapFromPlace) > AWAY)
                        .isPresent();
    }

    private void send(String robot, int place) {
        placeOf.put(robot, place);
        failed.remove(robot);
        arrived.remove(robot);
        var order = new NewGoal(robot, mapFromPlaces.get(place));
        drives.ask(Objects.requireNonNull(agentOf.get(robot)), order, ending -> {
            if (isOnItsWayTo(order.mapFromGoal(), robot)) {
                ended(robot, place, ending);
            }
        });
    }

    private boolean isOnItsWayTo(Pose2d mapFromGoal, String robot) {
        Integer place = placeOf.get(robot);
        return place != null && mapFromPlaces.get(place).equals(mapFromGoal);
    }

    private void ended(String robot, int place, ConversationResult<GoalReached> ending) {
        switch (ending) {
            case ConversationResult.Informed<GoalReached> _ -> arrived.add(robot);
            case ConversationResult.Silent<GoalReached> _ -> {
                failed.add(robot);
                disperseSoon(Duration.ZERO);
            }
            default -> {
                failed.add(robot);
                vain.computeIfAbsent(robot, _ -> new HashSet<>()).add(place);
            }
        }
        publish();
    }

    private void publish() {
        long there = placeOf.keySet().stream().filter(arrived::contains).count();
        self.state("%d of %d robots have reached their place".formatted(there, placeOf.size()));
    }

    /// One time of asking.
    private final class Round {
        private final NavigableMap<String, double[]> costsByRobot = new TreeMap<>();
        private final List<String> waitingFor = new ArrayList<>();

        void ask(String agent, PoseReport report) {
            agentOf.put(report.robot(), agent);
            boolean knowsPaths = self.directory().capabilities(agent).contains(PathCostService.CAPABILITY);
            if (!knowsPaths) {
                costsByRobot.put(report.robot(), straight(report.mapFromBase().position()));
                return;
            }
            waitingFor.add(agent);
            costs.ask(agent, new Places(mapFromPlaces), ending -> answered(agent, report, ending));
        }

        private void answered(String agent, PoseReport report, ConversationResult<Costs> ending) {
            costs(report, ending).ifPresent(own -> costsByRobot.put(report.robot(), own));
            waitingFor.remove(agent);
            allotWhenAllHaveAnswered();
        }

        private Optional<double[]> costs(PoseReport report, ConversationResult<Costs> ending) {
            return switch (ending) {
                case ConversationResult.Informed<Costs>(Costs reported) ->
                    Optional.of(reported.costs().stream()
                            .mapToDouble(Double::doubleValue)
                            .toArray());
                case ConversationResult.Silent<Costs> _, ConversationResult.Cancelled<Costs> _ -> Optional.empty();
                case ConversationResult.Refused<Costs> _,
                        ConversationResult.Failed<Costs> _,
                        ConversationResult.NotUnderstood<Costs> _ ->
                    Optional.of(straight(report.mapFromBase().position()));
            };
        }

        private double[] straight(Point2d from) {
            return mapFromPlaces.stream()
                    .mapToDouble(place -> place.position().distanceTo(from))
                    .toArray();
        }

        void allotWhenAllHaveAnswered() {
            if (waitingFor.isEmpty() && this.equals(round)) {
                round = null;
                allot(costsByRobot);
            }
        }
    }
}
