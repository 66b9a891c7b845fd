package own;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.Topic;
import rsal.agent.message.PoseReport;
import rsal.agent.message.Text;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Goes to and fro between two posts and challenges each robot that comes near.
public final class Sentry implements AgentType {
    private static final Parameter<Double> X1 = Parameter.number("x1", 0, -1000, 1000, "m", "Where the first post is.");
    private static final Parameter<Double> Y1 = Parameter.number("y1", 0, -1000, 1000, "m", "Where the first post is.");
    private static final Parameter<Double> X2 =
            Parameter.number("x2", 0, -1000, 1000, "m", "Where the second post is.");
    private static final Parameter<Double> Y2 =
            Parameter.number("y2", 0, -1000, 1000, "m", "Where the second post is.");
    private static final Parameter<Double> REST =
            Parameter.number("rest", 2, 0, 600, "s", "How long it stays at a post.");
    private static final Parameter<Double> REACH =
            Parameter.number("reach", 5, 0, 100, "m", "A robot nearer than this is challenged.");

    @Override
    public String key() {
        return "sentry";
    }

    @Override
    public String description() {
        return "Goes to and fro between two posts and challenges each robot that comes near.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(X1, Y1, X2, Y2, REST, REACH);
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(Localizer.class, Navigator.class);
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> new Watch(self, self.robot().orElseThrow(), arguments).begin();
    }

    /// Said when a post has been reached.
    ///
    /// @param post 1 or 2
    public record Visit(String robot, int post) {
        public static final Topic<Visit> TOPIC = new Topic<>("visit", Visit.class);

        @Override
        public String toString() {
            return "%s is at post %d".formatted(robot, post);
        }
    }

    /// One sentry on duty.
    private static final class Watch {
        private static final Duration A_WHILE = Duration.ofSeconds(10);

        private final AgentContext self;
        private final Robot robot;
        private final Localizer localizer;
        private final Navigator navigator;
        private final List<Pose2d> posts;
        private final Duration rest;
        private final double reach;
        private final Set<String> near = new TreeSet<>();
        private Runnable stop = () -> {};

        Watch(AgentContext self, Robot robot, Arguments arguments) {
            this.self = self;
            this.robot = robot;
            this.localizer = robot.require(Localizer.class);
            this.navigator = robot.require(Navigator.class);
            this.posts = List.of(
                    new Pose2d(arguments.get(X1), arguments.get(Y1), 0),
                    new Pose2d(arguments.get(X2), arguments.get(Y2), 0));
            this.rest = arguments.seconds(REST);
            this.reach = arguments.get(REACH);
        }

        void begin() {
            self.subscribe(PoseReport.TOPIC, message -> look(message.content()));
            self.atEnd(() -> stop.run());
            goTo(1);
        }

        private void goTo(int post) {
            self.state("going to post " + post);
            var drive = navigator.goTo(posts.get(post - 1), Tolerance.position(0.5));
            stop = drive::cancel;
            drive.result().thenAccept(result -> self.scheduler().execute(() -> ended(post, result)));
        }

        private void ended(int post, Result result) {
            switch (result) {
                case Result.Reached _ -> {
                    self.publish(Visit.TOPIC, new Visit(robot.id(), post));
                    self.state("standing at post " + post);
                    self.scheduler().after(rest, () -> goTo(other(post)));
                }
                case Result.Stuck _ -> {
                    self.publish(Text.TOPIC, new Text("I am stuck on my way to post %d.".formatted(post)));
                    goTo(other(post));
                }
                case Result.NoPath(String why) -> {
                    self.state("no way to post %d: %s".formatted(post, why));
                    self.scheduler().after(A_WHILE, () -> goTo(other(post)));
                }
                case Result.Cancelled _ -> self.state("off duty");
            }
        }

        private static int other(int post) {
            return 3 - post;
        }

        private void look(PoseReport report) {
            localizer.latest().ifPresent(estimate -> {
                double distance = estimate.value().mapFromBase().distanceTo(report.mapFromBase());
                if (distance >= reach) {
                    near.remove(report.robot());
                } else if (near.add(report.robot())) {
                    self.publish(Text.TOPIC, new Text("Halt, %s!".formatted(report.robot())));
                }
                self.show("near", near.isEmpty() ? "nobody" : String.join(", ", near));
            });
        }
    }
}
