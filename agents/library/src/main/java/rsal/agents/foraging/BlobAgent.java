package rsal.agents.foraging;

import java.util.ArrayList;
import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agents.parts.AgentTypeBase;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Thing;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Knows of colored things where they lie, as somebody does who has seen them, and has them fetched ([FetchRequests]).
/// In a
/// simulated world it puts them there at its start; a simulated thing may so stand for one that a real robot
/// fetches. Needs no robot.
public final class BlobAgent extends AgentTypeBase {
    static final Parameter<List<Point2d>> PLACES = Parameter.places("places", "Positions of the things.");
    static final Parameter<String> COLOR =
            Parameter.text("color", "#2ca02c", "Color of the things for cameras, #rrggbb or a name.");
    static final Parameter<Boolean> SPAWN = Parameter.flag(
            "spawn",
            true,
            "Whether the agent adds the things to the simulated world. If not, they must be there already.");

    private static final Solid CAN =
            Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.08), 0.1); // fits between a gripper's paddles

    public BlobAgent() {
        super(
                "blob",
                "Adds colored things to a simulated world, and requests that robots fetch them.",
                List.of(PLACES, COLOR, SPAWN),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Rgb color = Spotting.color(arguments, COLOR)
                .orElseThrow(() -> new IllegalArgumentException("'color' must be a color, #rrggbb or a name."));
        List<Point2d> places = arguments.get(PLACES);
        if (arguments.get(SPAWN)) {
            self.simulation().ifPresent(world -> put(world, self.name(), places, color));
        }
        List<CollectGoal> things =
                places.stream().map(place -> new CollectGoal(color, place)).toList();
        new Known(self, things).begin();
    }

    private static void put(SimulationControl world, String owner, List<Point2d> places, Rgb color) {
        int number = 0;
        for (Point2d place : places) {
            String name = owner + "-" + ++number;
            var thing = Thing.of(name, new Pose2d(place.x(), place.y(), 0), CAN, color)
                    .asGrippable();
            if (world.add(thing) instanceof Placement.Refused(String why)) {
                throw new IllegalStateException("'%s' can't be put at %s: %s".formatted(name, place, why));
            }
        }
    }

    /// What it knows of, until each has been collected, by whomever.
    private static final class Known {
        private final AgentContext self;
        private final Request<CollectGoal, String> orders;
        private final List<CollectGoal> open;
        private final int all;

        Known(AgentContext self, List<CollectGoal> things) {
            this.self = self;
            this.orders = FetchRequests.service(self);
            this.open = new ArrayList<>(things);
            this.all = things.size();
        }

        void begin() {
            self.subscribe(Collected.TOPIC, message -> forget(message.content().goal()));
            List.copyOf(open).forEach(this::ask);
            publish();
        }

        private void ask(CollectGoal thing) {
            if (!open.contains(thing)) {
                return;
            }
            FetchRequests.master(self)
                    .ifPresentOrElse(
                            master -> orders.ask(master, thing, ending -> {
                                if (ending instanceof ConversationResult.Informed) {
                                    forget(thing);
                                } else { // others have asked for it, or nobody could
                                    later(thing);
                                }
                            }),
                            () -> later(thing));
        }

        private void later(CollectGoal thing) {
            self.scheduler().after(FetchRequests.REPEAT, () -> ask(thing));
        }

        private void forget(CollectGoal thing) {
            open.removeIf(thing::isSame);
            publish();
        }

        private void publish() {
            self.state("%d of %d fetched".formatted(all - open.size(), all));
        }
    }
}
