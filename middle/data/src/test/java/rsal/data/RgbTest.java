package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RgbTest {
    @Test
    void isReadAsItIsWritten() {
        for (int packed : new int[] {0, 0x00ff00, 0x0072b2, 0xffffff}) {
            Rgb color = Rgb.of(packed);
            assertThat(color.packed()).isEqualTo(packed);
            assertThat(Rgb.parse(color.toString())).contains(color);
        }
        assertThat(Rgb.parse("#0072B2")).contains(new Rgb(0, 0x72, 0xb2));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "red", "0072b2", "#0072b", "#0072b2a", "#0072bg", "#+072b2"})
    void readsNothingElse(String text) {
        assertThat(Rgb.parse(text)).isEmpty();
    }

    @Test
    void refusesPartsOutOfRange() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Rgb(256, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Rgb(0, -1, 0));
    }
}
