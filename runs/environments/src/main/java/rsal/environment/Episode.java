package rsal.environment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Contact;
import rsal.engine.SteppedRun;
import rsal.engine.SteppedWatch;
import rsal.engine.report.RunResult;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedRobot;

/// One run of an environment, from its reset to its end. Of one thread at a time.
public final class Episode implements Truth, AutoCloseable {
    static final int TRUTH = 3; // numbers of a pose

    private final Blueprint blueprint;
    private final RunPlan plan;
    private final SteppedRun run;
    private final List<Learner> learners;
    private final List<String> learnerIds; // in their order; a learner itself knows its robot in its turn only
    private final List<String> robots; // ids of all, in the order of the plan
    private final Map<String, Integer> numbers = new HashMap<>(); // of robots, by id
    private final Pose2d[] truth; // map from base, by number
    private final int[] collisions; // so far, by number
    private final List<List<LearnerObservation.Reader>> readers = new ArrayList<>(); // by learner
    private final int[] sizes; // of observations, of which each takes time to ask for
    private final List<LearnerAction.Actor> actors = new ArrayList<>();
    private final float[] low; // of an action
    private final float[] high;
    private final float[] own; // action of a learner
    private int counted; // contacts

    private Episode(Blueprint blueprint, RunPlan plan, SteppedRun run, LearnerType type) {
        this.blueprint = blueprint;
        this.plan = plan;
        this.run = run;
        this.learners = List.copyOf(type.byRobot().values());
        this.learnerIds = learners.stream().map(learner -> learner.robot().id()).toList();
        this.robots = plan.robots().stream().map(robot -> robot.spec().id()).toList();
        robots.forEach(id -> numbers.put(id, numbers.size()));
        this.truth = new Pose2d[robots.size()];
        Arrays.fill(truth, Pose2d.ORIGIN);
        this.collisions = new int[robots.size()];
        this.sizes = blueprint.observations().stream()
                .mapToInt(observation -> observation.fields().size())
                .toArray();
        this.low = blueprint.action().low();
        this.high = blueprint.action().high();
        this.own = new float[low.length];
        look();
        for (Learner learner : learners) {
            readers.add(learner.readers(this));
            actors.add(blueprint.action().of(learner));
        }
    }

    /// Makes the robots and agents of an episode, and simulates the first step of the scenario, in which learners
    /// stand:
    /// after it, all sensors have measured.
    ///
    /// @throws rsal.settings.InvalidSettings when the scenario has errors
    /// @throws IllegalArgumentException when a robot lacks what an observation or an action needs
    public static Episode begin(Blueprint blueprint, long seed) {
        return begin(blueprint, seed, new SteppedWatch());
    }

    /// The same, for somebody who looks whether agents return.
    public static Episode begin(Blueprint blueprint, long seed, SteppedWatch watch) {
        var type = new LearnerType(blueprint.observations());
        RunPlan plan = blueprint.plan(seed, type);
        SteppedRun run = SteppedRun.begin(plan, watch);
        try {
            run.advance(1);
            return new Episode(blueprint, plan, run, type);
        } catch (RuntimeException | Error e) {
            run.close();
            throw e;
        }
    }

    /// What does not change from episode to episode, unless the scenario draws how many robots there are.
    public Blueprint.Layout layout() {
        var roles = new LinkedHashMap<String, String>();
        var colors = new LinkedHashMap<String, String>();
        plan.robots().stream().map(PlannedRobot::spec).forEach(robot -> {
            roles.put(robot.id(), robot.role());
            colors.put(robot.id(), robot.color());
        });
        return new Blueprint.Layout(learnerIds, roles, colors, plan.step().toNanos() / 1e9 * blueprint.steps());
    }

    /// Checks what a step would do. Does nothing once it is over.
    ///
    /// @param actions [Blueprint#acted] numbers for each learner
    /// @param at index of the first one
    /// @throws IllegalArgumentException when one is not finite, or is none of the choices
    public void check(float[] actions, int at) {
        if (isOver()) {
            return;
        }
        int size = own.length;
        for (int learner = 0; learner < actors.size(); learner++) {
            for (int i = 0; i < size; i++) {
                blueprint.action().check(i, actions[at + learner * size + i], learnerIds.get(learner));
            }
        }
    }

    /// Acts, and simulates the time of a step. Does nothing once it is over.
    ///
    /// @param actions [Blueprint#acted] numbers for each learner, which were checked. Those beyond their limits
    ///     count as the limit
    /// @param at index of the first one
    public void step(float[] actions, int at) {
        if (isOver()) {
            return;
        }
        int size = own.length;
        for (int learner = 0; learner < actors.size(); learner++) {
            for (int i = 0; i < size; i++) {
                own[i] = Math.clamp(actions[at + learner * size + i], low[i], high[i]);
            }
            if (learners.get(learner).isActive()) {
                actors.get(learner).act(own, 0);
            }
        }
        run.advance(blueprint.steps());
        look();
    }

    private void look() {
        Optional<SimulationControl> world = run.simulation();
        if (world.isEmpty()) {
            return;
        }
        for (int i = 0; i < truth.length; i++) {
            int number = i;
            world.get().truth(robots.get(i)).ifPresent(pose -> truth[number] = pose);
        }
        List<Contact> contacts = world.get().contacts();
        for (Contact contact : contacts.subList(counted, contacts.size())) {
            count(contact.robot());
            count(contact.other());
        }
        counted = contacts.size();
    }

    private void count(String entity) {
        Integer number = numbers.get(entity);
        if (number != null) {
            collisions[number]++;
        }
    }

    /// Writes what all learners observe now.
    ///
    /// @param at index of the first number
    public void observe(float[] to, int at) {
        int next = at;
        for (List<LearnerObservation.Reader> own : readers) {
            for (int i = 0; i < own.size(); i++) {
                own.get(i).read(to, next);
                next += sizes[i];
            }
        }
    }

    /// Writes the true pose of each robot in `map`, in the order of the plan: x, y [m] and heading [rad].
    public void truth(float[] to, int at) {
        for (int i = 0; i < truth.length; i++) {
            to[at + TRUTH * i] = (float) truth[i].x();
            to[at + TRUTH * i + 1] = (float) truth[i].y();
            to[at + TRUTH * i + 2] = (float) truth[i].theta();
        }
    }

    /// Writes how often each robot has touched something so far.
    public void collisions(int[] to, int at) {
        System.arraycopy(collisions, 0, to, at, collisions.length);
    }

    @Override
    public Pose2d truth(int robot) {
        return truth[robot];
    }

    /// {@inheritDoc}
    ///
    /// In the order of the plan.
    @Override
    public int number(String robot) {
        return numbers.getOrDefault(robot, -1);
    }

    @Override
    public int[] numbers(String role) {
        return plan.robots().stream()
                .map(PlannedRobot::spec)
                .filter(robot -> role.isEmpty() || robot.role().equals(role))
                .mapToInt(robot -> number(robot.id()))
                .toArray();
    }

    /// The map of its world.
    OccupancyGrid map() {
        return plan.map();
    }

    public boolean isOver() {
        return run.outcome().isPresent();
    }

    /// How the scenario ended it; empty while it goes on.
    public Optional<String> outcome() {
        return run.outcome();
    }

    /// The metrics of the scenario as they are now, by name; those without a value are left out.
    public Map<String, Double> metrics() {
        return run.metrics();
    }

    /// Names of all metrics of the scenario, also of those without a value.
    public List<String> metricNames() {
        return run.metricNames();
    }

    /// Ends it, if it goes on.
    public RunResult finish() {
        return run.finish();
    }

    @Override
    public void close() {
        run.close();
    }
}
