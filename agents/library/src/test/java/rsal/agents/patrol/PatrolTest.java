package rsal.agents.patrol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.Test;
import rsal.agents.FakeBattery;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.agents.patrol.strategy.PatrolStrategyType;
import rsal.data.BatteryState.Charging;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Navigator;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.settings.Arguments;
import rsal.settings.Plugin;
import rsal.settings.PluginChoice;

/// Agents of types `patrol` and `worker` together.
class PatrolTest {
    private final Scene scene = new Scene();
    private final Map<String, FakeRobot> robots = new TreeMap<>();
    private final Map<String, Double> at = new TreeMap<>();
    private final Map<String, FakeBattery> batteries = new TreeMap<>();

    /// No path leads to or from places with y above 5; fails as often as a test wants before that.
    private static final class Walled extends DeviceCore implements Planner {
        private int failures;

        Walled(String robot, int failures) {
            super(new DeviceInfo(robot, "planner", "walled"));
            this.failures = failures;
        }

        @Override
        public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
            boolean isOpen = mapFromStart.y() > 5 == mapFromGoal.y() > 5 && mapFromStart.y() <= 5;
            if (!isOpen || failures-- > 0) {
                return CompletableFuture.completedFuture(new Result.NoPath("A wall."));
            }
            var path = new Path2d(List.of(mapFromStart.position(), mapFromGoal.position()));
            return CompletableFuture.completedFuture(new Result.Found(path, path.length(), 0));
        }
    }

    private FakeRobot guard(String id, double x) {
        return guard(id, x, Optional.empty());
    }

    private FakeRobot guard(String id, double x, Optional<Planner> planner) {
        FakeRobot robot = scene.robot(id, "guard");
        var battery = new FakeBattery(id);
        robots.put(id, robot);
        batteries.put(id, battery);
        var able = robot.robot.with(battery).with(robot.places);
        var equipped = planner.map(able::with).orElse(able);
        scene.start("worker", id, Optional.of(equipped), Map.of("chargers", "50 0; 90 0"));
        robot.isAt(x, 0);
        at.put(id, x);
        return robot;
    }

    private void patrol(Map<String, ?> arguments) {
        scene.start("patrol", "patrol", Optional.empty(), arguments);
        scene.advance(0);
    }

    private void charge(String id, double level, Charging charging) {
        batteries.get(id).is(level, charging, scene.scheduler.instant());
        scene.advance(0);
    }

    private double goal(String id) {
        return robots.get(id).navigator.goals.getLast().x();
    }

    private void reach(String id) {
        FakeRobot robot = robots.get(id);
        Pose2d goal = robot.navigator.goals.getLast();
        robot.isAt(goal.x(), goal.y());
        robot.navigator.reach();
        scene.advance(0);
    }

    @Test
    void eachPlaceGoesToTheOneThatIsNearAndThenToWhereNobodyWasForLong() {
        guard("a", 0);
        guard("b", 20);
        patrol(Map.of("places", "1 0; 3 0; 18 0", "strategy", strategy("bids")));
        assertThat(goal("a")).isEqualTo(1);
        assertThat(goal("b")).isEqualTo(18);
        scene.advance(10);
        reach("a");
        assertThat(goal("a")).as("not the one where it is").isEqualTo(3);
        assertThat(scene.said("patrol", Watch.TOPIC)).hasSize(1);
        assertThat(scene.said("patrol", Visited.TOPIC)).containsExactly(new Visited("a", new Point2d(1, 0)));
        assertThat(scene.state("patrol")).isEqualTo("watching 3 places, left alone for 7 s, at most 10 s");
    }

    private static PluginChoice strategy(String key) {
        PatrolStrategyType type = ServiceLoader.load(PatrolStrategyType.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(candidate -> candidate.key().equals(key))
                .findFirst()
                .orElseThrow();
        return new PluginChoice(type, Arguments.defaults(type.parameters()));
    }

    /// Drives for some time as the robots' goals are, along a line; at 1 m/s when no speed is given.
    private void drive(int seconds, String... ids) {
        drive(seconds, 1, ids);
    }

    private void drive(int seconds, double speed, String... ids) {
        for (int tenth = 0; tenth < 10 * seconds; tenth++) {
            for (String id : ids) {
                FakeRobot robot = robots.get(id);
                if (!robot.navigator.goals.isEmpty()) {
                    double apart = goal(id) - at.get(id);
                    at.put(id, at.get(id) + Math.clamp(apart, -0.1 * speed, 0.1 * speed));
                    robot.isAt(at.get(id), 0);
                }
            }
            scene.advance(0.1);
        }
    }

    private List<Double> visits(String id) {
        return scene.said(id, Visited.TOPIC).stream()
                .map(visited -> visited.mapFromPlace().x())
                .toList();
    }

    @Test
    void robotsDivideThePlacesAndDoNotStopAtThem() {
        guard("a", 0);
        guard("b", 20);
        patrol(Map.of("places", "1 0; 4 0; 18 0; 21 0"));
        drive(30, "a", "b");
        assertThat(visits("a")).hasSizeGreaterThan(4).containsOnly(1.0, 4.0);
        assertThat(visits("b")).hasSizeGreaterThan(4).containsOnly(18.0, 21.0);
    }

    @Test
    void patrolGoesOnWithoutTheAgentThatBeganIt() {
        guard("a", 0);
        patrol(Map.of("places", "1 0; 4 0"));
        drive(5, "a");
        scene.platform.stop("patrol");
        int before = visits("a").size();
        drive(20, "a");
        assertThat(visits("a")).hasSizeGreaterThan(before + 3);
    }

    @Test
    void placesOfOneThatIsSilentAreTakenOver() {
        guard("a", 0);
        guard("b", 20);
        patrol(Map.of("places", "1 0; 4 0; 18 0; 21 0"));
        drive(10, "a", "b");
        scene.platform.stop("b");
        drive(60, "a");
        assertThat(visits("a")).contains(18.0, 21.0);
    }

    @Test
    void oneThatChargesLeavesItsPlacesToTheOthersAndComesBack() {
        guard("a", 0);
        guard("b", 20);
        patrol(Map.of("places", "1 0; 4 0; 18 0; 21 0"));
        drive(10, "a", "b");
        charge("b", 0.2, Charging.DISCHARGING);
        assertThat(goal("b")).isEqualTo(50);
        drive(60, "a", "b");
        assertThat(visits("a")).contains(18.0, 21.0);
        charge("b", 0.95, Charging.CHARGING);
        int before = visits("b").size();
        drive(60, "a", "b");
        assertThat(visits("b")).hasSizeGreaterThan(before);
    }

    private static final List<Point2d> THREE = List.of(new Point2d(1, 0), new Point2d(4, 0), new Point2d(8, 0));

    private void order(String sender, List<Point2d> places, String strategy) {
        scene.hear(sender, PatrolOrder.TOPIC, new PatrolOrder(places, strategy(strategy), Duration.ZERO));
    }

    @Test
    void whatOthersReportOfPlacesCounts() {
        guard("a", 0);
        order("patrol", THREE, "bids");
        scene.hear("x", Visited.TOPIC, new Visited("x", THREE.get(1), List.of(Visited.UNKNOWN, 0.0, 300.0)));
        drive(3, "a");
        assertThat(goal("a")).as("left alone for long before it came").isEqualTo(8);
        drive(20, "a");
        List<Double> last = scene.said("a", Visited.TOPIC).getFirst().idleness();
        assertThat(last.get(1)).isBetween(2.0, 10.0);
        assertThat(last.get(2)).as("not visited yet").isBetween(300.0, 310.0);
    }

    @Test
    void fresherReportOfAPlaceCounts() {
        guard("a", 0);
        order("patrol", THREE, "bids");
        scene.hear("x", Visited.TOPIC, new Visited("x", THREE.get(1), List.of(200.0, 0.0, 300.0)));
        scene.hear("x", Visited.TOPIC, new Visited("x", THREE.get(2)));
        drive(3, "a");
        assertThat(goal("a")).isEqualTo(4);
    }

    @Test
    void oneThatJoinsLateReportsOnlyOfVisitsThatItKnows() {
        scene.advance(500);
        guard("a", 0);
        order("patrol", THREE, "cycle");
        drive(6, "a");
        assertThat(scene.said("a", Visited.TOPIC).getFirst().idleness())
                .containsExactly(0.0, Visited.UNKNOWN, Visited.UNKNOWN);
    }

    @Test
    void placesBehindAWallAreLeftOut() {
        guard("a", 0, Optional.of(new Walled("a", 0)));
        guard("b", 8, Optional.of(new Walled("b", 0)));
        var places = List.of(new Point2d(4, 9), THREE.get(0), THREE.get(1), THREE.get(2));
        order("patrol", places, "balanced");
        drive(60, "a", "b");
        assertThat(visits("a")).hasSizeGreaterThan(4);
        assertThat(visits("b")).hasSizeGreaterThan(4);
        for (String id : List.of("a", "b")) {
            assertThat(robots.get(id).navigator.goals).noneMatch(goal -> goal.y() > 5);
            assertThat(scene.said(id, Visited.TOPIC))
                    .allMatch(visited -> visited.idleness().getFirst() == Visited.UNKNOWN)
                    .allMatch(visited -> visited.idleness().get(places.indexOf(visited.mapFromPlace())) == 0);
        }
    }

    @Test
    void plannerThatFailsAtFirstIsAskedAgain() {
        guard("a", 0, Optional.of(new Walled("a", 9)));
        order("patrol", THREE, "cycle");
        drive(40, "a");
        assertThat(visits("a")).contains(1.0, 4.0, 8.0);
    }

    @Test
    void orderOfAnotherCountsOnlyWhenTheFirstSenderIsSilent() {
        guard("a", 0);
        var others = List.of(new Point2d(-2, 0), new Point2d(-5, 0));
        for (int i = 0; i < 8; i++) {
            order("first", THREE, "cycle");
            order("second", others, "cycle");
            drive(5, "a");
        }
        assertThat(visits("a")).hasSizeGreaterThan(4).allMatch(x -> x > 0);
        for (int i = 0; i < 8; i++) {
            order("second", others, "cycle");
            drive(5, "a");
        }
        assertThat(visits("a").getLast()).isNegative();
    }

    @Test
    void slowRobotIsGivenTheTimeThatItNeeds() {
        guard("a", 0);
        order("patrol", List.of(new Point2d(60, 0)), "cycle");
        scene.advance(3);
        drive(650, 0.1, "a");
        assertThat(visits("a")).contains(60.0);
    }

    @Test
    void oneThatHasChargedBeginsAtThePlaceThatIsNear() {
        guard("a", 0);
        order("patrol", List.of(new Point2d(1, 0), new Point2d(4, 0), new Point2d(60, 0)), "cr");
        drive(6, "a");
        charge("a", 0.2, Charging.DISCHARGING);
        drive(60, "a");
        charge("a", 0.95, Charging.CHARGING);
        drive(3, "a");
        assertThat(goal("a")).isEqualTo(60);
    }

    @Test
    void orderThatNobodyCanFollowIsRefused() {
        PluginChoice cycle = strategy("cycle");
        assertThatThrownBy(() -> new PatrolOrder(Collections.nCopies(1001, THREE.getFirst()), cycle, Duration.ZERO))
                .hasMessageContaining("'1001'");
        assertThatThrownBy(() -> new PatrolOrder(THREE, cycle, Duration.ofSeconds(-1)))
                .hasMessageContaining("'PT-1S'");
        var type = new Patrol();
        var other = new Plugin() {
            @Override
            public String key() {
                return type.key();
            }

            @Override
            public String description() {
                return type.description();
            }
        };
        var choice = new PluginChoice(other, Arguments.defaults(List.of()));
        assertThatThrownBy(() -> new PatrolOrder(THREE, choice, Duration.ZERO)).hasMessageContaining("'patrol'");
    }

    @Test
    void placeThatCannotBeReachedIsLeftOut() {
        guard("a", 0);
        patrol(Map.of("places", "1 0; 4 0; 8 0", "strategy", strategy("cycle")));
        scene.advance(3);
        double first = goal("a");
        robots.get("a").navigator.end(new Navigator.Result.NoPath("A wall."));
        scene.advance(2);
        assertThat(goal("a")).isNotEqualTo(first);
    }

    @Test
    void driveThatTakesFarTooLongIsGivenUp() {
        guard("a", 0);
        patrol(Map.of("places", "1 0; 4 0; 8 0"));
        scene.advance(3);
        double first = goal("a");
        scene.advance(60);
        assertThat(robots.get("a").navigator.goals.stream().map(Pose2d::x)).anyMatch(goal -> goal != first);
    }

    @Test
    void placesAreFoundWhenNoneAreGiven() {
        guard("a", 0).places.result = new PlaceFinder.Result.Found(List.of(new Point2d(7, 0), new Point2d(8, 0)));
        patrol(Map.of("places", "", "count", 2, "strategy", strategy("bids")));
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(7);
    }

    @Test
    void guardWhoseBatteryIsLowChargesWhileAnotherTakesItsPlace() {
        guard("a", 0);
        patrol(Map.of("places", "1 0", "strategy", strategy("bids")));
        guard("b", 20);
        charge("a", 0.2, Charging.DISCHARGING);
        assertThat(goal("a")).as("the nearest charger").isEqualTo(50);
        assertThat(goal("b")).isEqualTo(1);
        reach("a");
        charge("a", 0.2, Charging.DISCHARGING);
        scene.advance(6);
        assertThat(goal("a")).as("the next, as nothing comes of the first").isEqualTo(90);
        reach("a");
        charge("a", 0.5, Charging.CHARGING);
        scene.advance(60);
        assertThat(scene.state("a")).isEqualTo("charging at (90.0, 0.0)");
        charge("a", 0.95, Charging.CHARGING);
        robots.get("b").navigator.end(new Navigator.Result.NoPath("A wall."));
        scene.advance(1);
        assertThat(goal("a")).isEqualTo(1);
    }

    @Test
    void guardsAreChargedWhereNobodyElseIs() {
        guard("a", 40);
        guard("b", 45);
        patrol(Map.of("places", "1 0", "strategy", strategy("bids")));
        charge("b", 0.2, Charging.DISCHARGING);
        assertThat(goal("b")).isEqualTo(50);
        scene.advance(60);
        charge("a", 0.2, Charging.DISCHARGING);
        assertThat(goal("a")).isEqualTo(90);
    }

    @Test
    void guardThatIsSentAwayFromItsChargerGoesBackAndTakesNoJobs() {
        guard("a", 40);
        patrol(Map.of("places", "1 0", "strategy", strategy("bids")));
        charge("a", 0.2, Charging.DISCHARGING);
        scene.order("a", 5, 0);
        assertThat(goal("a")).isEqualTo(5);
        reach("a");
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(50);
        charge("a", 0.95, Charging.CHARGING);
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(1);
    }

    @Test
    void errandsComeFirst() {
        guard("a", 0);
        patrol(Map.of("places", "1 0", "strategy", strategy("bids")));
        scene.order("a", 5, 0);
        assertThat(goal("a")).isEqualTo(5);
        scene.advance(10);
        assertThat(goal("a")).isEqualTo(5);
        reach("a");
        scene.advance(6);
        assertThat(goal("a")).isEqualTo(1);
    }
}
