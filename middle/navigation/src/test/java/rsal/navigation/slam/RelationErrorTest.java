package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;

class RelationErrorTest {
    private static final List<Pose2d> RIGHT =
            List.of(new Pose2d(0, 0, 0), new Pose2d(1, 0, 0), new Pose2d(2, 0, 0), new Pose2d(1, 0.5, 0));

    @Test
    void doesNotCareWhereAMapBegins() {
        var moved = new Pose2d(5, -3, 1);

        RelationError error =
                RelationError.ofNext(RIGHT, RIGHT.stream().map(moved::compose).toList());

        assertThat(error.count()).isEqualTo(3);
        assertThat(error.meters()).isCloseTo(0, Offset.offset(1e-12));
        assertThat(error.radians()).isCloseTo(0, Offset.offset(1e-12));
    }

    @Test
    void countsABendOnce() {
        List<Pose2d> bent =
                List.of(RIGHT.get(0), new Pose2d(1, 0, 0.3), new Pose2d(1, 0, 0.3).compose(new Pose2d(1, 0, 0)));

        RelationError error = RelationError.ofNext(RIGHT.subList(0, 3), bent);

        assertThat(error.meters()).isCloseTo(0, Offset.offset(1e-12));
        assertThat(error.radians()).isCloseTo(0.15, Offset.offset(1e-12));
    }

    @Test
    void nearPosesAreThoseThatDoNotFollowOnEachOther() {
        List<Pose2d> off = List.of(RIGHT.get(0), RIGHT.get(1), RIGHT.get(2), new Pose2d(1, 0.9, 0));

        RelationError error = RelationError.ofNear(RIGHT, off, 1.2);

        assertThat(error.count()).isEqualTo(2); // 0 and 3, 1 and 3
        assertThat(error.meters()).isCloseTo(0.4, Offset.offset(1e-12));
    }

    @Test
    void nothingToJudgeIsNoNumber() {
        assertThat(RelationError.ofNext(List.of(), List.of()).meters()).isNaN();
        assertThatThrownBy(() -> RelationError.ofNext(RIGHT, List.of())).hasMessageContaining("4 correct");
    }
}
