package rsal.scene;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Solid;

/// A body that is somewhere.
///
/// @param name unique in its scene
/// @param blocks in its own frame
/// @param mapFromEntity where it is at first
/// @param height of its underside above the floor [m]
/// @param givingPower with which it charges each robot that touches it, if that takes so much [W]
public record Entity(String name, List<Block> blocks, Pose2d mapFromEntity, double height, double givingPower) {
    public Entity {
        blocks = List.copyOf(blocks);
    }

    /// A body that charges nobody.
    public Entity(String name, List<Block> blocks, Pose2d mapFromEntity, double height) {
        this(name, blocks, mapFromEntity, height, 0);
    }

    /// The blocks of a plain body on the floor.
    ///
    /// @param color of those pieces that have none of their own
    public static List<Block> blocks(Solid body, Rgb color) {
        return body.pieces().stream()
                .map(piece -> new Block(piece, Surface.PLAIN.in(piece.color().orElse(color))))
                .toList();
    }

    /// The same blocks, those first whose tops are lowest.
    public static List<Block> lowestFirst(List<Block> blocks) {
        return blocks.stream()
                .sorted(Comparator.comparingDouble(block -> block.prism().top()))
                .toList();
    }

    /// What blocks look like, each piece in its color, the [#lowestFirst]; empty when there are none.
    public static Optional<Solid> look(List<Block> blocks) {
        return blocks.isEmpty()
                ? Optional.empty()
                : Optional.of(new Solid(lowestFirst(blocks).stream()
                        .map(block -> block.prism().in(block.surface().color()))
                        .toList()));
    }
}
