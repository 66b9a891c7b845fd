package rsal.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import org.junit.jupiter.api.Test;

class BitmapTest {
    /// As of a chess board, so that no two pixels make one rectangle.
    private static Bitmap checkered(int side) {
        var solid = new BitSet(side * side);
        for (int i = 0; i < side * side; i++) {
            solid.set(i, (i % side + i / side) % 2 == 0);
        }
        return new Bitmap(side, side, solid);
    }

    @Test
    void rectanglesAreAllThatIsSolid() {
        var solid = new BitSet();
        solid.set(0, 5); // a row of three and the beginning of the next
        assertThat(new Bitmap(3, 2, solid).rectangles(10))
                .containsExactly(new int[] {0, 3, 0, 1}, new int[] {0, 2, 1, 2});
        assertThat(checkered(4).rectangles(8)).hasSize(8);
    }

    @Test
    void oneMoreThanEnoughIsTheLast() {
        assertThat(checkered(100).rectangles(30)).hasSize(31);
    }
}
