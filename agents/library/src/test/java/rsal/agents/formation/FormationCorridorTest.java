package rsal.agents.formation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;

class FormationCorridorTest {
    private static final List<Pose2d> STRAIGHT =
            FormationCorridor.along(List.of(new Point2d(0, 0), new Point2d(20, 0)), 1);

    /// Room in the middle lane everywhere but from one place to another [m].
    private static boolean[][] room(int lanes, double from, double to) {
        var room = new boolean[STRAIGHT.size()][lanes];
        for (int i = 0; i < room.length; i++) {
            room[i][lanes / 2] = i * FormationCorridor.STEP < from || i * FormationCorridor.STEP > to;
        }
        return room;
    }

    @Test
    void posesAreEvenAndLookAlongTheWay() {
        List<Pose2d> poses =
                FormationCorridor.along(List.of(new Point2d(0, 0), new Point2d(5.2, 0), new Point2d(5.2, 10)), 1);
        for (int i = 1; i < poses.size() - 1; i++) {
            assertThat(poses.get(i).distanceTo(poses.get(i - 1))).isLessThanOrEqualTo(FormationCorridor.STEP + 1e-9);
        }
        assertThat(poses.getFirst()).isEqualTo(new Pose2d(0, 0, 0));
        assertThat(poses.getLast().isNear(new Pose2d(5.2, 10, Math.PI / 2), 1e-9, 1e-9))
                .isTrue();
        Pose2d corner = poses.get(10);
        assertThat(corner.theta()).isBetween(0.2, 1.2); // looks into the turn before it is there
    }

    @Test
    void isAColumnWhereThereIsNoRoomAndALittleBefore() {
        FormationCorridor lane = FormationCorridor.of(STRAIGHT, room(1, 8, 12));
        assertThat(lane.length()).isCloseTo(20, within(1e-9));
        assertThat(lane.fits(5, false)).isTrue();
        assertThat(lane.fits(7, false)).isFalse();
        assertThat(lane.fits(10, false)).isFalse();
        assertThat(lane.fits(12.5, true)).isTrue();
        assertThat(lane.fits(5, true))
                .as("not worth it to widen shortly before")
                .isFalse();
    }

    @Test
    void doesNotWidenForAFewMeters() {
        var room = room(1, 2, 8);
        room[(int) (11 / FormationCorridor.STEP)][0] = false; // 3 m further on
        FormationCorridor lane = FormationCorridor.of(STRAIGHT, room);
        assertThat(lane.fits(9, false)).isFalse();
        assertThat(lane.fits(12, true)).isTrue();
    }

    @Test
    void goesBesideTheWayWhereThereIsRoom() {
        var room = room(9, 8, 12);
        for (int i = 0; i < room.length; i++) {
            boolean middle = room[i][4];
            room[i][5] = middle;
            room[i][6] = middle;
            room[i][7] = true; // 1.5 m to the left
        }
        FormationCorridor lane = FormationCorridor.of(STRAIGHT, room);
        assertThat(lane.fits(10, false)).isTrue();
        assertThat(lane.beside(10).y()).isCloseTo(1.5, within(1e-9));
        assertThat(lane.beside(2).y()).isZero();
        assertThat(lane.onWay(10).y()).isZero();
    }

    @Test
    void aColumnTrailsStraightBehindTheBeginning() {
        FormationCorridor lane = FormationCorridor.of(STRAIGHT, room(1, 0, 20));
        assertThat(lane.onWay(-3).isNear(new Pose2d(-3, 0, 0), 1e-9, 1e-9)).isTrue();
        assertThat(lane.onWay(99)).isEqualTo(STRAIGHT.getLast());
    }
}
