package rsal.agents.foraging;

import java.util.Optional;
import java.util.function.Consumer;
import rsal.agent.AgentContext;
import rsal.agents.parts.PoseReporter;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.device.BlobFinder;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.ColorNames;
import rsal.settings.Parameter;

/// Sees patches of color through a robot's blob finder and says where they are in the map, each time it sees them.
/// Those at the border of an image are left out: of what lies beyond nothing is known, so that their middle would be
/// somewhere else.
public final class Spotting {
    private final AgentContext self;
    private final BlobFinder camera;
    private final PoseReporter reporter;
    private final Optional<Rgb> color;
    private final double range;
    private final Consumer<CollectGoal> onSeen;

    /// @param color of what counts; empty for all
    /// @param range up to which it counts [m]
    public Spotting(
            AgentContext self,
            Robot robot,
            PoseReporter reporter,
            Optional<Rgb> color,
            double range,
            Consumer<CollectGoal> onSeen) {
        this.self = self;
        this.camera = robot.require(BlobFinder.class);
        this.reporter = reporter;
        this.color = color;
        this.range = range;
        this.onSeen = onSeen;
    }

    /// A color that was typed; empty when it was left out.
    ///
    /// @throws IllegalArgumentException when it is none
    public static Optional<Rgb> color(Arguments arguments, Parameter<String> parameter) {
        String text = arguments.get(parameter);
        return text.isEmpty()
                ? Optional.empty()
                : Optional.of(ColorNames.parse(text)
                        .orElseThrow(() ->
                                new IllegalArgumentException("'%s' must be a color, #rrggbb or a name, not '%s'. %s"
                                        .formatted(parameter.name(), text, ColorNames.advice(text)))));
    }

    public void begin() {
        self.subscribe(camera, reading -> reporter.mapFromBase().ifPresent(pose -> look(reading.value(), pose)));
    }

    private void look(Blobs image, Pose2d mapFromBase) {
        for (Blob blob : image.blobs()) {
            boolean whole = blob.left() > 0 && blob.right() < image.width();
            if (whole
                    && blob.range() <= range
                    && color.filter(c -> !c.equals(blob.color())).isEmpty()) {
                Optional<Point2d> baseFromBlob = image.baseFromBlob(blob);
                baseFromBlob
                        .map(mapFromBase::transform)
                        .map(p -> new CollectGoal(blob.color(), p))
                        .ifPresent(onSeen);
            }
        }
    }
}
