package rsal.ros2.tf;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.tf.FrameHistory.Placed;
import rsal.ros2.tf.TransformLookup.Failure;
import rsal.ros2.tf.TransformLookup.Found;
import rsal.ros2.tf.TransformLookup.Reason;

/// Where frames are in others at a time: a tree, whose transforms come by `tf` and, of what never moves, by
/// `tf_static`.
/// Between two stamps of a frame, positions are interpolated linearly and rotations on the shortest way; nothing is
/// extrapolated. The rules are those of tf2, but for two: of two transforms with the same stamp, the later one counts;
/// and a frame whose stamps go back by more than the history begins again, as its sender has.
///
/// Whatever comes, it stays small: names, frames, samples and levels are limited. Of one
/// thread.
public final class TransformBuffer {
    /// As long as tf2 keeps transforms.
    public static final Duration HISTORY = Duration.ofSeconds(10);

    private static final int LONGEST_NAME = 256; // characters
    private static final int MOST_FRAMES = 10_000;
    private static final int MOST_SAMPLES = 100_000; // of all frames; beyond that, each frame keeps fewer
    private static final int MOST_LEVELS = 1_000; // as in tf2

    private final long history; // ns
    private final Map<String, FrameHistory> frames = new HashMap<>(); // by child
    private int samples; // of all frames

    /// The way from a frame up to the root of its tree.
    ///
    /// @param fromFrame where the first one is in each of its frames, from itself upwards
    /// @param stop why it ends below the root; empty where it does not
    private record Ascent(Map<String, FrameTransform> fromFrame, Optional<Failure> stop) {}

    /// @param history for how long transforms are kept
    public TransformBuffer(Duration history) {
        this.history = history.toNanos();
    }

    /// Where a frame is at a time.
    ///
    /// @return whether it is kept: names are of 1 to 256 characters and differ, and it is not too old
    public boolean add(StampedTransform transform) {
        if (!isPossible(transform)) {
            return false;
        }
        FrameHistory frame = frames.computeIfAbsent(transform.child(), _ -> new FrameHistory());
        int before = frame.count();
        if (before > 0 && transform.stamp() < frame.newest() - history) {
            frame.dropBefore(Long.MAX_VALUE);
        }
        frame.put(transform.stamp(), placed(transform));
        frame.dropBefore(frame.newest() - history);
        samples += frame.count() - before;
        if (samples > MOST_SAMPLES && frame.count() > 1) {
            frame.dropOldest();
            samples--;
        }
        return true;
    }

    /// Where a frame always is.
    ///
    /// @return as [#add]
    public boolean addFixed(StampedTransform transform) {
        if (!isPossible(transform)) {
            return false;
        }
        FrameHistory frame = frames.computeIfAbsent(transform.child(), _ -> new FrameHistory());
        samples -= frame.count();
        frame.fix(placed(transform));
        return true;
    }

    private boolean isPossible(StampedTransform transform) {
        String child = transform.child();
        String parent = transform.parent();
        return isName(child)
                && isName(parent)
                && !child.equals(parent)
                && transform.stamp() >= 0
                && transform.parentFromChild().isFinite()
                && (frames.size() < MOST_FRAMES || frames.containsKey(child));
    }

    private static boolean isName(String frame) {
        return !frame.isEmpty() && frame.length() <= LONGEST_NAME;
    }

    private static Placed placed(StampedTransform transform) {
        return new Placed(transform.parent(), transform.parentFromChild());
    }

    /// Forgets where a frame and those below it were, if they move, as after a time that went back.
    ///
    /// @return the frames that are forgotten
    public List<String> clear(String top) {
        String above = RosMessages.frame(top);
        List<String> forgotten = frames.keySet().stream()
                .filter(frame -> !history(frame).isFixed())
                .filter(frame -> ascendNewest(frame).fromFrame.containsKey(above))
                .toList();
        for (String frame : forgotten) {
            samples -= history(frame).count();
            frames.remove(frame);
        }
        return forgotten;
    }

    /// Where a frame was in another one at a time.
    ///
    /// @param stamp [ns]; 0 for the newest time at which all frames in between have transforms
    public TransformLookup find(String target, String source, long stamp) {
        String to = RosMessages.frame(target);
        String from = RosMessages.frame(source);
        if (to.equals(from)) {
            return new Found(FrameTransform.NONE);
        }
        if (stamp != 0) {
            return join(to, ascend(to, stamp), ascend(from, stamp));
        }
        Ascent targets = ascendNewest(to);
        Ascent sources = ascendNewest(from);
        TransformLookup newest = join(to, targets, sources);
        if (!(newest instanceof Found)) {
            return newest;
        }
        return moving(targets, sources).stream()
                .map(frame -> history(frame).newest())
                .min(Long::compare)
                .map(common -> join(to, ascend(to, common), ascend(from, common)))
                .orElse(newest); // nothing moves
    }

    /// The frames between two ones, as they are joined now, that move; none where they are not joined.
    public List<String> moving(String target, String source) {
        Ascent targets = ascendNewest(RosMessages.frame(target));
        Ascent sources = ascendNewest(RosMessages.frame(source));
        return meeting(targets, sources).isPresent() ? moving(targets, sources) : List.of();
    }

    private List<String> moving(Ascent targets, Ascent sources) {
        String top = meeting(targets, sources).orElseThrow();
        var moving = new ArrayList<String>();
        for (Ascent ascent : List.of(targets, sources)) {
            Iterator<String> frame = ascent.fromFrame.keySet().iterator();
            for (String at = frame.next(); !at.equals(top); at = frame.next()) {
                if (!history(at).isFixed()) {
                    moving.add(at);
                }
            }
        }
        return moving;
    }

    private FrameHistory history(String frame) {
        FrameHistory its = frames.get(frame);
        if (its == null) {
            throw new IllegalArgumentException("No transform (TF) is of the frame '%s'.".formatted(frame));
        }
        return its;
    }

    private Ascent ascend(String frame, long stamp) {
        return ascend(frame, its -> its.at(stamp), (at, its) -> extrapolation(at, its, stamp));
    }

    private Ascent ascendNewest(String frame) {
        return ascend(frame, its -> Optional.of(its.last()), (at, _) -> Failure.of(Reason.UNKNOWN_FRAME, at, ""));
    }

    private static Failure extrapolation(String frame, FrameHistory its, long stamp) {
        return stamp < its.oldest()
                ? new Failure(Reason.PAST, frame, "", its.oldest(), stamp)
                : new Failure(Reason.FUTURE, frame, "", its.newest(), stamp);
    }

    private interface Stop {
        Failure at(String frame, FrameHistory its);
    }

    private Ascent ascend(String frame, Function<FrameHistory, Optional<Placed>> where, Stop stop) {
        var fromFrame = new LinkedHashMap<String, FrameTransform>();
        String at = frame;
        FrameTransform atFromFrame = FrameTransform.NONE;
        while (fromFrame.size() < MOST_LEVELS && fromFrame.putIfAbsent(at, atFromFrame) == null) {
            FrameHistory its = frames.get(at);
            if (its == null) {
                return new Ascent(fromFrame, Optional.empty());
            }
            Optional<Placed> placed = where.apply(its);
            if (placed.isEmpty()) {
                return new Ascent(fromFrame, Optional.of(stop.at(at, its)));
            }
            atFromFrame = placed.get().parentFromFrame().compose(atFromFrame);
            at = placed.get().parent();
        }
        return new Ascent(fromFrame, Optional.of(Failure.of(Reason.LOOP, frame, "")));
    }

    /// The lowest frame that is above both, or one of them.
    private static Optional<String> meeting(Ascent targets, Ascent sources) {
        return targets.fromFrame.keySet().stream()
                .filter(sources.fromFrame::containsKey)
                .findFirst();
    }

    private TransformLookup join(String target, Ascent targets, Ascent sources) {
        Optional<String> top = meeting(targets, sources);
        if (top.isPresent()) {
            FrameTransform topFromTarget = at(targets, top.get());
            FrameTransform topFromSource = at(sources, top.get());
            return new Found(topFromTarget.inverse().compose(topFromSource));
        }
        String source = sources.fromFrame.keySet().iterator().next();
        for (String frame : List.of(target, source)) {
            if (!isKnown(frame)) {
                return Failure.of(Reason.UNKNOWN_FRAME, frame, "");
            }
        }
        return targets.stop.or(() -> sources.stop).orElseGet(() -> Failure.of(Reason.NOT_CONNECTED, target, source));
    }

    private static FrameTransform at(Ascent ascent, String frame) {
        return Optional.ofNullable(ascent.fromFrame.get(frame)).orElseThrow();
    }

    private boolean isKnown(String frame) {
        return frames.containsKey(frame)
                || frames.values().stream()
                        .anyMatch(each -> each.last().parent().equals(frame));
    }
}
