package rsal.server;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.Handler;
import io.javalin.http.HandlerType;
import io.javalin.http.Header;
import io.javalin.http.HttpResponseException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.engine.LiveRun;
import rsal.engine.Operator;
import rsal.engine.RunOperator;
import rsal.engine.report.Answer;
import rsal.engine.report.PlacedThing;
import rsal.engine.report.Snapshot;
import rsal.map.RosMap;
import rsal.model.RobotModels;
import rsal.scenario.RunPlan;
import rsal.server.CurrentRun.Numbered;
import rsal.server.Messages.Added;
import rsal.server.Messages.Addition;
import rsal.server.Messages.AgentAddition;
import rsal.server.Messages.AgentName;
import rsal.server.Messages.Armed;
import rsal.server.Messages.Control;
import rsal.server.Messages.ControlWish;
import rsal.server.Messages.Drive;
import rsal.server.Messages.Motors;
import rsal.server.Messages.NewAgent;
import rsal.server.Messages.NewRobot;
import rsal.server.Messages.Order;
import rsal.server.Messages.Plan;
import rsal.server.Messages.Refused;
import rsal.server.Messages.Release;
import rsal.server.Messages.Removal;
import rsal.server.Messages.Restart;
import rsal.server.Messages.RobotPose;
import rsal.server.Messages.RunInfo;
import rsal.server.Messages.Saying;
import rsal.server.Messages.Sent;
import rsal.server.Messages.Speed;
import rsal.server.Messages.Stopped;
import rsal.server.Messages.SweepRunAgain;
import rsal.server.Page.Asset;

/// What can be asked and told over HTTP. `GET` shows, `POST` changes and needs the token. A refusal comes as
/// [Messages.Refused] with a status: 400 not understood, 401 no token, 409 not possible now, 422 bad settings.
final class Api {
    private static final Logger LOG = LoggerFactory.getLogger(Api.class);
    private static final String REFUSED = "refused"; // of a request
    private static final int GRID_HEADER = 2 * Integer.BYTES + 3 * Double.BYTES;
    private static final double FARTHEST = 1e6; // [m], from the map's origin

    private final RunSlots seats;
    private final ScenarioCatalog shelf;
    private final AccessControl gate;
    private final Page page;
    private final Exposition exposition;
    private final SweepApi sweeps;
    private final TextApi texts;

    /// @param exposition what monitors are shown
    Api(RunSlots seats, ScenarioCatalog shelf, AccessControl gate, Page page, Exposition exposition, SweepApi sweeps) {
        this.seats = seats;
        this.shelf = shelf;
        this.gate = gate;
        this.page = page;
        this.exposition = exposition;
        this.sweeps = sweeps;
        this.texts = new TextApi(seats, shelf, gate);
    }

    /// All is there for each of the runs side by side, below its address.
    void configure(RoutesConfig routes) {
        routes.before(RunSlots.BESIDE + "/*", seats::find); // also where the answer is the same for all
        configure(new Routes(routes, ""));
        configure(new Routes(routes, RunSlots.BESIDE));
        routes.get("/metrics", exposition::answer);
        routes.get(RunSlots.BESIDE + "/*", request -> asset(request, page, pathIn(seats.find(request), request)));
        serve(routes, page, this::isLate);
    }

    private void configure(Routes routes) {
        routes.before("/api/*", this::passOver);
        routes.get("/api/run", request -> answer(request, info(request)));
        routes.get("/api/scenarios", request -> answer(request, shelf.all()));
        routes.get("/api/scenarios/picture", request -> {
            request.contentType("image/png").result(shelf.picture(asked(request, "scenario")));
        });
        routes.get("/api/status", this::status);
        routes.get("/api/map/{run}", this::map);
        routes.get("/api/drawn/{run}", this::drawn);
        routes.get("/api/drawn/{run}/files", this::drawnFiles);
        routes.get("/api/abilities", request -> {
            answerWhenDone(request, running(request).inspector().abilities(asked(request, "robot")));
        });
        routes.get("/api/readings", request -> {
            answerWhenDone(request, readings(request));
        });
        routes.get("/api/numbers", request -> {
            seats.find(request).numbers().want(asked(request, "robot"));
            answerWhenDone(request, readings(request), Numbers::of);
        });
        routes.get("/api/numbers/past", request -> {
            answer(
                    request,
                    seats.find(request)
                            .numbers()
                            .past(asked(request, "robot"), asked(request, "device"), asked(request, "number")));
        });
        routes.get("/api/trails", request -> answer(request, seats.find(request).trails(Past.asked(request))));
        routes.get(
                "/api/communication",
                request -> answerWhenDone(request, seen(request).inspector().communication()));
        routes.get("/api/links", request -> {
            answerWhenDone(request, links(request));
        });
        routes.get("/api/blobs", request -> {
            answerWhenDone(request, readings(request), told -> CameraViews.of(told.readings()));
        });
        routes.get("/api/mounts", request -> {
            answerWhenDone(request, readings(request), told -> DeviceMountings.of(told.readings()));
        });
        routes.get("/api/costs", request -> {
            answerWhenDone(request, running(request).inspector().costs(asked(request, "robot")));
        });
        routes.get("/api/sayable", request -> answer(request, Descriptions.sayable(RunOperator.sayable())));
        routes.get(
                "/api/topics",
                request -> answerWhenDone(request, seen(request).inspector().topics()));
        routes.get("/api/routine", request -> answerWhenDone(request, routine(request)));
        routes.get("/api/agent", request -> answerWhenDone(request, inside(request)));

        command(routes, "pause", request -> running(request).pause());
        command(routes, "resume", request -> running(request).resume());
        command(routes, "step", request -> running(request).step());
        command(
                routes,
                "speed",
                request -> running(request)
                        .speed(SpeedFactor.of(read(request, Speed.class).factor())));
        command(routes, "stop", request -> running(request).stop());
        command(routes, "place", request -> {
            RobotPose to = read(request, RobotPose.class);
            answerWhenDone(request, running(request).operator().place(to.robot(), pose(to)));
        });
        command(routes, "believe", request -> {
            RobotPose to = read(request, RobotPose.class);
            answerWhenDone(request, running(request).operator().believe(to.robot(), pose(to)));
        });
        command(routes, "add", request -> {
            Addition wish = read(request, Addition.class);
            Pose2d there = pose(wish.x(), wish.y(), wish.heading());
            PlacedThing prop = PlacedThing.valueOf(wish.kind().name());
            answerWhenDone(request, running(request).operator().add(prop, there));
        });
        command(routes, "add-robot", request -> {
            RobotPose wish = read(request, RobotPose.class);
            answerWhenDone(request, running(request).operator().addRobot(wish.robot(), pose(wish)));
        });
        routes.get(
                "/api/robots/models", request -> answer(request, Descriptions.robotModels(RobotModels.readBuiltIn())));
        command(routes, "new-robot", request -> {
            NewRobot wish = read(request, NewRobot.class);
            Pose2d there = pose(wish.x(), wish.y(), wish.heading());
            answerWhenDone(request, running(request).operator().newRobot(wish.model(), there));
        });
        command(
                routes,
                "remove",
                request -> answerWhenDone(
                        request,
                        running(request)
                                .operator()
                                .remove(read(request, Removal.class).name())));
        command(routes, "goal", request -> {
            RobotPose to = read(request, RobotPose.class);
            answerWhenDone(request, running(request).operator().goTo(to.robot(), pose(to)));
        });
        command(routes, "drive", request -> {
            Drive wish = read(request, Drive.class);
            answerWhenDone(
                    request,
                    running(request)
                            .operator()
                            .drive(wish.robot(), Steering.driver(wish.driver()), Steering.velocity(wish)));
        });
        commandOfAll(routes, "release", request -> {
            Release wish = read(request, Release.class);
            answerWhenDone(request, running(request).operator().release(wish.robot(), Steering.driver(wish.driver())));
        });
        command(routes, "behavior", request -> {
            Order wish = read(request, Order.class);
            answerWhenDone(request, running(request).operator().behave(wish.robot(), wish.behavior()));
        });
        routes.get("/api/agents/types", request -> answer(request, Descriptions.agentTypes(RunOperator.agentTypes())));
        command(routes, "new-agent", request -> {
            NewAgent wish = read(request, NewAgent.class);
            answerWhenDone(request, running(request).operator().newAgent(wish.type(), wish.robot(), wish.arguments()));
        });
        command(routes, "add-agent", request -> {
            AgentAddition wish = read(request, AgentAddition.class);
            answerWhenDone(request, running(request).operator().addAgent(wish.like(), wish.robot()));
        });
        command(
                routes,
                "start-agent",
                request -> answerWhenDone(
                        request,
                        running(request)
                                .operator()
                                .startAgent(read(request, AgentName.class).name())));
        command(
                routes,
                "stop-agent",
                request -> answerWhenDone(
                        request,
                        running(request)
                                .operator()
                                .stopAgent(read(request, AgentName.class).name())));
        command(routes, "say", request -> {
            Saying wish = read(request, Saying.class);
            answerWhenDone(request, running(request).operator().say(wish.to(), wish.topic(), wish.fields()));
        });
        commandOfAll(routes, "estop", request -> answerWhenDone(request, seats.estop()));
        command(
                routes,
                "rearm",
                request -> answerWhenDone(request, running(request).operator().rearm()));
        commandOfAll(routes, "motors", request -> {
            Motors wish = read(request, Motors.class);
            if (wish.on()) {
                gate.lease().check(operator(request));
                answerWhenDone(request, running(request).operator().rearm(wish.robot()));
            } else { // a stop
                answerWhenDone(request, running(request).operator().stop(wish.robot()));
            }
        });
        commandOfAll(routes, "check", request -> {
            RunPlan plan = plan(request, read(request, Restart.class, RunServer.MAX_TEXT));
            answer(request, new Plan(Long.toString(plan.seed()), Descriptions.arguments(plan)));
        });
        command(routes, "restart", request -> {
            int stops = seats.stops();
            restart(request, plan(request, read(request, Restart.class, RunServer.MAX_TEXT)), stops);
        });
        command(routes, "watch", request -> {
            int stops = seats.stops();
            restart(request, sweeps.plan(read(request, SweepRunAgain.class)), stops);
        });

        texts.configure(routes);
        sweeps.configure(routes);
        configureSeats(routes);
        configureControl(routes);
    }

    /// Who has control, of this server and all of its runs.
    private void configureControl(Routes routes) {
        routes.get("/api/control", this::control);
        routes.post("/api/control", controlled(request -> {
            ControlWish wish = read(request, ControlWish.class);
            gate.lease().take(operator(request), wish.name(), wish.over());
        }));
        routes.put("/api/control", controlled(request -> gate.lease().keep(operator(request))));
        routes.delete("/api/control", controlled(request -> gate.lease().giveBack(operator(request))));
    }

    /// Changes who has control, with the token, and answers who has it then.
    private Handler controlled(Handler change) {
        return request -> {
            gate.authorize(request.header(Header.AUTHORIZATION));
            change.handle(request);
            control(request);
        };
    }

    private void control(Context request) {
        answer(request, new Control(gate.lease().holder(), gate.lease().isHeldBy(operator(request))));
    }

    /// What was asked for by that name; empty when it was left out.
    static String asked(Context request, String name) {
        String asked = request.queryParam(name);
        return asked == null ? "" : asked;
    }

    /// As [AccessControl#OPERATOR] says; empty when it doesn't.
    static String operator(Context request) {
        String operator = request.header(AccessControl.OPERATOR);
        return operator == null ? "" : operator;
    }

    private void configureSeats(Routes routes) {
        routes.get("/api/beside", request -> answer(request, Descriptions.sideBySide(seats.all())));
        routes.post("/api/beside", request -> {
            int stops = seats.stops();
            authorize(request, gate);
            RunPlan plan = plan(request, read(request, Restart.class, RunServer.MAX_TEXT));
            answer(request, Descriptions.seat(seats.open(plan, stops)));
        });
        routes.delete("/api/beside/{number}", request -> {
            authorize(request, gate);
            seats.close(request.pathParam("number"));
            answer(request, Map.of());
        });
    }

    /// After all else: the page, and refusals.
    ///
    /// @param isLate what is told nothing where it would be refused as things are
    static void serve(RoutesConfig routes, Page page, Predicate<Context> isLate) {
        routes.get("/*", request -> asset(request, page, request.path()));

        routes.exception(Refusal.class, (refusal, request) -> {
            if (refusal.status() == 409 && isLate.test(request)) {
                request.status(204);
            } else {
                refuse(request, refusal);
            }
        });
        routes.exception(
                HttpResponseException.class,
                (e, request) -> refuse(request, new Refusal(e.getStatus(), String.valueOf(e.getMessage()))));
        // what takes too long (PageServer) Javalin ends as an error of which it says nothing, then it cancels it; what
        // is there of an answer, or comes just then, is none
        routes.error(500, request -> {
            if (request.attribute(REFUSED) == null) {
                refuseLate(request);
            }
        });
        routes.exception(CancellationException.class, (_, request) -> refuseLate(request));
        routes.exception(IOException.class, (e, request) -> { // the client closed the connection, or sent no more
            LOG.debug("Could not answer {} {}.", request.method(), request.path(), e);
            refuse(request, new Refusal(400, "The request did not come as a whole."));
        });
        routes.exception(Exception.class, (e, request) -> {
            LOG.error("Could not answer {} {}.", request.method(), request.path(), e);
            refuse(request, new Refusal(500, "The server failed at this; its log says why."));
        });
    }

    /// What changes the run: only with the token, and while nobody else has control. Answers `{}` unless told
    /// otherwise.
    private void command(Routes routes, String name, Handler handler) {
        commandOfAll(routes, name, request -> {
            gate.lease().check(operator(request));
            handler.handle(request);
        });
    }

    /// What whoever has the token may do at any time. Answers `{}` unless told otherwise.
    private void commandOfAll(Routes routes, String name, Handler handler) {
        routes.post("/api/run/" + name, request -> {
            gate.authorize(request.header(Header.AUTHORIZATION));
            answer(request, Map.of());
            Operator.tells(gate.lease().name(operator(request)), () -> {
                handler.handle(request);
                return request;
            });
        });
    }

    /// Lets through who may change something now; see [AccessControl#authorize(String, String)].
    static void authorize(Context request, AccessControl gate) {
        gate.authorize(request.header(Header.AUTHORIZATION), operator(request));
    }

    private void status(Context request) {
        Numbered now = seats.find(request).now();
        request.future(() -> now.run()
                .freshSnapshot()
                .toCompletableFuture()
                .thenAccept(snapshot -> answer(request, Descriptions.status(now.number(), now.run(), snapshot))));
    }

    /// Whoever asks about a run that another one has followed meanwhile is told nothing: that is no mistake of theirs.
    private void passOver(Context request) {
        String run = lookedAt(request);
        if (!run.isEmpty() && !isPresent(run, seats.find(request).now())) {
            request.status(204).skipRemainingHandlers();
        }
    }

    /// Whether somebody looks at a run that is over or not there any more, and could not know that yet: another one may
    /// be about to follow it.
    private boolean isLate(Context request) {
        String run = lookedAt(request);
        return !run.isEmpty()
                && seats.look(request)
                        .map(RunSlot::now)
                        .filter(now -> now.isOver() || !isPresent(run, now))
                        .isPresent();
    }

    /// The number of the run that somebody wants to see something of; empty where that is not said, and in commands.
    private static String lookedAt(Context request) {
        return request.method().equals(HandlerType.GET) ? asked(request, "run") : "";
    }

    private static boolean isPresent(String run, Numbered now) {
        return run.equals(Integer.toString(now.number()));
    }

    /// What of a seat's page is asked for.
    private static String pathIn(RunSlot seat, Context request) {
        return request.path()
                .substring(RunSlots.BESIDE
                        .replace("{seat}", Integer.toString(seat.number()))
                        .length());
    }

    /// Also when it is over: it remembers what it was asked then.
    private LiveRun seen(Context request) {
        return seats.find(request).now().run();
    }

    /// What devices of a robot have told last; at another time than now when that is asked for.
    private CompletionStage<Answer> readings(Context request) {
        String robot = asked(request, "robot");
        return Past.askedBack(request)
                .<CompletionStage<Answer>>map(time -> CompletableFuture.completedStage(
                        seats.find(request).recollection().readings(robot, time)))
                .orElseGet(() -> seen(request).inspector().readings(robot));
    }

    /// Who hears whom; at another time than now when that is asked for.
    private CompletionStage<Answer> links(Context request) {
        return Past.askedBack(request)
                .<CompletionStage<Answer>>map(time -> CompletableFuture.completedStage(
                        seats.find(request).recollection().links(time)))
                .orElseGet(() -> running(request).inspector().links(asked(request, "robot")));
    }

    /// What an agent has in mind; at another time than now when that is asked for.
    private CompletionStage<Answer> inside(Context request) {
        String name = asked(request, "name");
        LiveRun run = seen(request);
        Recollection recollection = seats.find(request).recollection();
        recollection.want(name);
        CompletionStage<Answer> now = run.inspector().inside(name);
        return Past.askedBack(request)
                .map(time -> later(
                        now,
                        answer -> answer instanceof Answer.Seen(var agent)
                                ? new Answer.Seen(recollection.inside(agent, time, run.events(0)))
                                : answer))
                .orElse(now);
    }

    /// What agents say all the time; what they said shortly before another time than now when that is asked for.
    private CompletionStage<Answer> routine(Context request) {
        String topic = asked(request, "topic");
        return Past.askedBack(request)
                .map(time -> seen(request).inspector().routine(topic, time, Past.SHORTLY))
                .orElseGet(() -> seen(request).inspector().routine(topic));
    }

    /// Not on the run's thread, which has better to do.
    private static CompletionStage<Answer> later(CompletionStage<Answer> stage, UnaryOperator<Answer> told) {
        return stage.thenApplyAsync(told, Thread::startVirtualThread);
    }

    private LiveRun running(Context request) {
        Numbered now = seats.find(request).now();
        if (now.isOver()) {
            throw new Refusal(409, "The run is over. Restart it first.");
        }
        return now.run();
    }

    private RunInfo info(Context request) {
        Numbered now = seats.find(request).now();
        return Descriptions.run(
                now.number(), now.run().plan(), now.team(now.run().snapshot()));
    }

    /// @param stops how many emergency stops there had been when it was asked for
    private void restart(Context request, RunPlan plan, int stops) {
        sweeps.checkBeside(plan);
        seats.restart(seats.find(request), plan, stops);
        answer(request, info(request));
    }

    /// What the wish asks for; otherwise as the run is now.
    private RunPlan plan(Context request, Restart wish) {
        LiveRun run = seats.find(request).now().run();
        return new RestartReader(shelf, run.plan(), run.snapshot().speed()).read(wish);
    }

    private static Pose2d pose(RobotPose to) {
        return pose(to.x(), to.y(), to.heading());
    }

    private static Pose2d pose(double x, double y, double heading) {
        if (!(Math.abs(x) <= FARTHEST && Math.abs(y) <= FARTHEST && Double.isFinite(heading))) {
            throw new Refusal(400, "(%s, %s) with heading %s is not a place.".formatted(x, y, heading));
        }
        return new Pose2d(x, y, heading);
    }

    private void map(Context request) {
        RunSlot seat = seats.find(request);
        Numbered now = seat.now();
        String run = request.pathParam("run");
        if (wasBefore(run, now)) {
            request.status(204);
        } else if (isPresent(run, now)) {
            answerPacked(request, seat.floor(now));
        } else {
            throw new Refusal(404, "Only the map of run %d is there.".formatted(now.number()));
        }
    }

    /// Whether a number is that of a run that another one has followed, which who asks about it could not know.
    private static boolean wasBefore(String run, Numbered now) {
        return run.matches("[1-9]\\d{0,8}") && Integer.parseInt(run) < now.number();
    }

    /// @param bytes as [#packed] packs them
    static void answerPacked(Context request, byte[] bytes) {
        request.header(Header.CONTENT_ENCODING, "gzip");
        request.contentType("application/octet-stream").result(bytes);
    }

    /// A map that a robot has drawn; see [Messages.DrawnMap].
    private void drawn(Context request) {
        if (wasBefore(request.pathParam("run"), seats.find(request).now())) {
            request.status(204);
        } else {
            answer(request, drawn(request, String.valueOf(request.queryParam("robot"))));
        }
    }

    static void answer(Context request, OccupancyGrid drawn) {
        answerPacked(request, packed(bytes(drawn)));
    }

    /// As [Messages.DrawnMap] has it.
    private static byte[] bytes(OccupancyGrid drawn) {
        ByteBuffer bytes =
                ByteBuffer.allocate(GRID_HEADER + drawn.cells().length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.putInt(drawn.width()).putInt(drawn.height());
        bytes.putDouble(drawn.resolution()).putDouble(drawn.originX()).putDouble(drawn.originY());
        return bytes.put(drawn.cells()).array();
    }

    /// The same as files that ROS and scenarios read, to be saved.
    private void drawnFiles(Context request) throws IOException {
        String robot = String.valueOf(request.queryParam("robot"));
        answerFiles(request, robot, drawn(request, robot));
    }

    static void answerFiles(Context request, String robot, OccupancyGrid drawn) throws IOException {
        var packed = new ByteArrayOutputStream();
        try (var zip = new ZipOutputStream(packed)) {
            zip.putNextEntry(new ZipEntry(robot + ".pgm"));
            zip.write(RosMap.pgm(drawn));
            zip.putNextEntry(new ZipEntry(robot + ".yaml"));
            zip.write(RosMap.yaml(drawn, robot + ".pgm").getBytes(StandardCharsets.UTF_8));
        }
        request.header(Header.CONTENT_DISPOSITION, "attachment; filename=\"%s-map.zip\"".formatted(robot));
        request.contentType("application/zip").result(packed.toByteArray());
    }

    private OccupancyGrid drawn(Context request, String robot) {
        RunSlot seat = seats.find(request);
        Numbered now = seat.now();
        Optional<Duration> time = Past.askedBack(request);
        Optional<OccupancyGrid> drawn = time.isPresent()
                ? seat.recollection().map(robot, asked(request, "device"), time.get())
                : drawn(now.run().snapshot(), request);
        return drawn.filter(_ -> request.pathParam("run").equals(Integer.toString(now.number())))
                .orElseThrow(() -> new Refusal(
                        404, "Robot (%s) has drawn no map in this run.".formatted(Refusal.shortened(robot))));
    }

    /// A map that the `robot` has drawn: by its `device`, or the first where none is named.
    static Optional<OccupancyGrid> drawn(Snapshot snapshot, Context request) {
        String device = asked(request, "device");
        return snapshot.robots().stream()
                .filter(view -> view.id().equals(asked(request, "robot")))
                .flatMap(view -> view.maps().stream())
                .filter(drawn -> device.isEmpty() || device.equals(drawn.device()))
                .map(drawn -> drawn.map().value())
                .findFirst();
    }

    static byte[] packed(byte[] bytes) {
        var packed = new ByteArrayOutputStream();
        try (var gzip = new GZIPOutputStream(packed)) {
            gzip.write(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e); // nothing in memory throws it
        }
        return packed.toByteArray();
    }

    private static void asset(Context request, Page page, String path) {
        Asset asset = page.find(path)
                .orElseThrow(
                        () -> new Refusal(404, "There is no (%s) here.".formatted(Refusal.shortened(request.path()))));
        if (asset.hashed()) {
            request.header(Header.CACHE_CONTROL, "max-age=31536000, immutable");
        }
        request.header(Header.VARY, Header.ACCEPT_ENCODING);
        boolean packed = asset.packed().isPresent() && takesGzip(request.header(Header.ACCEPT_ENCODING));
        if (packed) {
            request.header(Header.CONTENT_ENCODING, "gzip");
        }
        request.contentType(asset.type()).result(packed ? asset.packed().orElseThrow() : asset.content());
    }

    /// @param accepted as RFC 9110, 12.5.3, has it: `gzip, deflate, br;q=0.5`
    private static boolean takesGzip(@Nullable String accepted) {
        return accepted != null
                && Arrays.stream(accepted.split(",", -1))
                        .map(String::strip)
                        .anyMatch(one -> one.matches("gzip(\\s*;\\s*q=(1(\\.0*)?|0?\\.\\d*[1-9]\\d*))?"));
    }

    static <T extends Record> T read(Context request, Class<T> type) throws IOException {
        return read(request, type, RunServer.MAX_MESSAGE);
    }

    /// @param most bytes of the request's body
    static <T extends Record> T read(Context request, Class<T> type, int most) throws IOException {
        byte[] body = request.bodyInputStream().readNBytes(most + 1);
        if (body.length > most) {
            throw new Refusal(413, "A request has at most %d bytes.".formatted(most));
        }
        return Json.read(new String(body, StandardCharsets.UTF_8), type);
    }

    private static void answerWhenDone(Context request, CompletionStage<Answer> stage) {
        answerWhenDone(request, stage, told -> ReadingWords.of(told.readings()));
    }

    /// @param told what is told of readings
    private static void answerWhenDone(
            Context request, CompletionStage<Answer> stage, Function<Answer.Read, Record> told) {
        // not on the run's thread, which has better to do than to write
        request.future(() -> stage.thenAcceptAsync(
                        answer -> {
                            switch (answer) {
                                case Answer.Done _ -> answer(request, Map.of());
                                case Answer.Added(String name) -> answer(request, new Added(name));
                                case Answer.Sent(int goal) -> answer(request, new Sent(goal));
                                case Answer.Stopped(int robots) -> answer(request, new Stopped(robots));
                                case Answer.Armed(int on, var off) -> answer(request, new Armed(on, off));
                                case Answer.Able(var abilities) -> answer(request, Steering.abilities(abilities));
                                case Answer.Read read -> answer(request, told.apply(read));
                                case Answer.Heard(var all) -> answer(request, Descriptions.communication(all));
                                case Answer.Counted(var topics) -> answer(request, Descriptions.topics(topics));
                                case Answer.Bridged _ -> throw new IllegalStateException("No page asks for a bridge.");
                                case Answer.Repeated(var all) ->
                                    answer(request, Descriptions.routine(all, asked(request, "topic")));
                                case Answer.Linked linked -> answer(request, Descriptions.links(linked));
                                case Answer.Costed(var grid) ->
                                    grid.ifPresentOrElse(costs -> answer(request, costs), () -> request.status(204));
                                case Answer.Minded _ ->
                                    throw new IllegalStateException("No page asks for minds alone.");
                                case Answer.Seen(var agent) -> answer(request, Descriptions.inside(agent));
                                case Answer.Refused(String why) -> throw new Refusal(409, why);
                            }
                        },
                        Thread::startVirtualThread)
                .toCompletableFuture());
    }

    static void answer(Context request, Object message) {
        request.contentType("application/json").result(Json.write(message));
    }

    private static void refuseLate(Context request) {
        refuse(request, new Refusal(503, "The run did not answer in time. Maybe this machine is busy."));
    }

    private static void refuse(Context request, Refusal refusal) {
        request.attribute(REFUSED, true);
        request.status(refusal.status());
        answer(request, new Refused(refusal.sentence(), refusal.problems()));
    }
}
