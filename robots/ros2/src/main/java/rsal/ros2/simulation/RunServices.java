package rsal.ros2.simulation;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.device.GoalHandle;
import rsal.ros2.action.ActionServer;
import rsal.ros2.action.ActionServer.ServedGoal;
import rsal.ros2.action.ActionServer.Status;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.system.RunControl;

/// What of `simulation_interfaces` is about the run: its features and state are read, it is paused, resumed,
/// stepped, reset and ended.
final class RunServices implements ActionServer.Handler {
    private static final String PACKAGE = "simulation_interfaces/srv/";
    private static final int STOPPED = 0; // states
    private static final int PLAYING = 1;
    private static final int PAUSED = 2;
    private static final int QUITTING = 3;
    private static final int ALREADY_THERE = 101; // of SetSimulationState
    private static final int INCORRECT_TRANSITION = 103;
    private static final int TIME = 1; // what is reset
    private static final int STATE = 2;
    private static final int SPAWNED = 4;
    private static final int ALL = 255; // as the default 0
    private static final long MOST_STEPS = 1_000_000; // at once
    private static final long MOST_FEEDBACK = 100; // messages of a goal

    /// Spawning, deleting; categories; states of entities read and set; infos; spawnables; reset, of time, of states
    /// and of what was spawned; state of the simulation read and set.
    private static final List<Integer> ALWAYS = List.of(0, 1, 8, 10, 11, 12, 14, 20, 21, 22, 23, 24, 25);

    /// To pause; steps, single, several, as an action.
    private static final List<Integer> PAUSABLE = List.of(26, 31, 32, 33);

    private final RunControl control;
    private final Runnable restart;
    private final Runnable halt;
    private final InstantSource time;
    private Optional<Instant> stopped = Optional.empty(); // when it was, and stands since
    private boolean isChanging; // is to be paused or stopped with the next step
    private Optional<Stepping> stepping = Optional.empty();

    private record Stepping(ServedGoal goal, GoalHandle<Long, Long> steps) {}

    /// @param restart lets the time of ROS begin again
    /// @param halt ends what programs have commanded
    /// @param time the run's, which nobody resets
    RunServices(RunControl control, Runnable restart, Runnable halt, InstantSource time) {
        this.control = control;
        this.restart = restart;
        this.halt = halt;
        this.time = time;
    }

    /// @param prefix of names: `/rsal/`
    void serve(Services services, String prefix) {
        services.serve(prefix + "get_simulator_features", PACKAGE + "GetSimulatorFeatures", _ -> features());
        services.serve(prefix + "get_simulation_state", PACKAGE + "GetSimulationState", _ -> state());
        services.serveLater(
                prefix + "set_simulation_state",
                PACKAGE + "SetSimulationState",
                request -> set(request.message("state").integer("state")).thenApply(ResultCode::toBytes));
        services.serve(
                prefix + "reset_simulation",
                PACKAGE + "ResetSimulation",
                request -> reset((int) request.integer("scope")).toBytes());
        services.serveLater(
                prefix + "step_simulation",
                PACKAGE + "StepSimulation",
                request -> step(request.integer("steps")).thenApply(ResultCode::toBytes));
    }

    private byte[] features() {
        var features = new ArrayList<>(ALWAYS);
        if (control.isPausable()) {
            features.addAll(PAUSABLE);
        }
        CdrWriter response = new CdrWriter().int32(features.size());
        features.forEach(feature -> response.int16(feature.shortValue()));
        return response.int32(0) // formats of resources
                .text("RSAL: worlds in the plane; robots have devices and localizers of their own")
                .toBytes();
    }

    /// Others may resume and pause it, too. Then it has another time than when it was stopped.
    private int now() {
        if (!control.isPaused()) {
            stopped = Optional.empty();
            return PLAYING;
        }
        return stopped.filter(time.instant()::equals).isPresent() ? STOPPED : PAUSED;
    }

    private byte[] state() {
        var response = new CdrWriter().int8((byte) now());
        return ResultCode.OK.write(response).toBytes();
    }

    private CompletionStage<ResultCode> set(long state) {
        if (state == now()) {
            return completed(new ResultCode(ALREADY_THERE, "The simulation is in this state."));
        }
        return switch ((int) state) {
            case PLAYING -> {
                stopped = Optional.empty();
                control.resume();
                yield completed(ResultCode.OK);
            }
            case PAUSED, STOPPED -> {
                if (!control.isPausable()) {
                    yield completed(ResultCode.unsupported("A run in real time can't be paused."));
                }
                yield isChanging
                        ? completed(ResultCode.incorrectState("Another request is still pausing the simulation."))
                        : pause(() -> state == STOPPED ? stop() : ResultCode.OK);
            }
            case QUITTING -> {
                control.end();
                yield completed(ResultCode.OK);
            }
            default ->
                completed(new ResultCode(
                        INCORRECT_TRANSITION,
                        "There is no state %d to go to, but 0 (stopped), 1 (playing), 2 (paused) and 3 (quitting)."
                                .formatted(state)));
        };
    }

    /// Somebody may resume it before it stands. Then it plays on.
    ///
    /// @param then once it stands
    private CompletionStage<ResultCode> pause(Supplier<ResultCode> then) {
        stopped = Optional.empty();
        CompletableFuture<Void> standing = control.pause().toCompletableFuture();
        if (standing.isDone()) {
            return completed(then.get());
        }
        isChanging = true;
        var result = new CompletableFuture<ResultCode>();
        var _ = standing.thenRun(() -> {
            boolean stands = control.isPaused();
            control.execute(() -> {
                isChanging = false;
                result.complete(
                        stands && control.isPaused()
                                ? then.get()
                                : ResultCode.incorrectState("The simulation was resumed before it stood still."));
            });
        });
        return result;
    }

    /// As it was when it began, and paused. Nothing goes on that was commanded before.
    private ResultCode stop() {
        stopped = Optional.of(time.instant());
        halt.run();
        return reset(ALL);
    }

    private static CompletionStage<ResultCode> completed(ResultCode code) {
        return CompletableFuture.completedStage(code);
    }

    private ResultCode reset(int scope) {
        boolean isAll = scope == 0 || scope == ALL;
        if (!isAll && (scope & ~(TIME | STATE | SPAWNED)) != 0) {
            return ResultCode.failed(
                    "There is no scope %d, but 255 (all), or 1 (time), 2 (state), 4 (spawned) and sums of these."
                            .formatted(scope));
        }
        if (isAll || (scope & SPAWNED) != 0) {
            control.removeSpawned();
        }
        List<String> missing = isAll || (scope & STATE) != 0 ? control.restore() : List.of();
        if (isAll || (scope & TIME) != 0) {
            restart.run();
        }
        return missing.isEmpty()
                ? ResultCode.OK
                : ResultCode.failed("All is back but what was deleted: %s.".formatted(String.join(", ", missing)));
    }

    /// Why no steps can be made now.
    private Optional<ResultCode> refusal(long steps) {
        if (!control.isPausable()) {
            return Optional.of(ResultCode.unsupported("A run in real time can't be stepped."));
        }
        if (now() != PAUSED) {
            return Optional.of(ResultCode.incorrectState("Steps need a paused simulation. Set its state to 2 first."));
        }
        if (steps < 1 || steps > MOST_STEPS) { // of which those beyond 2^63 are below 0
            return Optional.of(ResultCode.failed(
                    "From 1 to %d steps can be made, not %s.".formatted(MOST_STEPS, Long.toUnsignedString(steps))));
        }
        return Optional.empty();
    }

    private CompletionStage<ResultCode> step(long steps) {
        Optional<ResultCode> refusal = refusal(steps);
        if (refusal.isPresent()) {
            return completed(refusal.get());
        }
        try {
            return control.step(steps).result().thenApply(made -> made(made, steps));
        } catch (IllegalStateException e) {
            return completed(busy());
        }
    }

    private static ResultCode busy() {
        return ResultCode.incorrectState("Other steps are still being made.");
    }

    private static ResultCode made(long made, long wanted) {
        return made == wanted
                ? ResultCode.OK
                : ResultCode.failed("Only %d of %d steps were made.".formatted(made, wanted));
    }

    /// Of `SimulateSteps`.
    @Override
    public void begin(ServedGoal goal, RosMessage fields) {
        long wanted = fields.integer("steps");
        Optional<ResultCode> refusal = refusal(wanted);
        if (refusal.isPresent()) {
            goal.end(Status.ABORTED, refusal.get()::write);
            return;
        }
        GoalHandle<Long, Long> steps;
        try {
            steps = control.step(wanted);
        } catch (IllegalStateException e) {
            goal.end(Status.ABORTED, busy()::write);
            return;
        }
        stepping = Optional.of(new Stepping(goal, steps));
        long each = Math.max(1, wanted / MOST_FEEDBACK);
        steps.onFeedback(made -> {
            if (made.value() % each == 0) {
                goal.publishFeedback(reported -> reported.int64(made.value()).int64(wanted - made.value()));
            }
        });
        steps.result().thenAccept(made -> end(goal, made, wanted));
    }

    private void end(ServedGoal goal, long made, long wanted) {
        stepping = Optional.empty();
        Consumer<CdrWriter> result = made(made, wanted)::write;
        goal.end(made == wanted ? Status.SUCCEEDED : goal.isCanceling() ? Status.CANCELED : Status.ABORTED, result);
    }

    @Override
    public void cancel(ServedGoal goal) {
        stepping.filter(each -> each.goal.equals(goal)).ifPresent(each -> each.steps.cancel());
    }

    @Override
    public void writeNoResult(CdrWriter writer) {
        ResultCode.notFound("There is no such goal.").write(writer);
    }
}
